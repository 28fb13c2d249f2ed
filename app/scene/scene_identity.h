// What is simulated, as a number: two documents with the same identity step through the same states.
#pragma once

#include <cstdint>

#include "app/scene/document.h"

namespace app {

// Takes in meshes, materials, forces, pins, time step and solver; not the title, the look, the camera, nor how long it
// lasts, so that a run can go on for longer.
std::uint64_t scene_identity(const Document& document);

// Of what the bases of its bodies are made from: equal where they are.
std::uint64_t basis_identity(const Document& document);

}  // namespace app
