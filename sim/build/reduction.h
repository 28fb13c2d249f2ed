// Makes the reduced system of a scene whose bodies have bases.
#pragma once

#include <memory>

#include "sim/build/parts.h"
#include "sim/scene.h"

namespace sim {

// Throws InputError where a scene asks for a basis and has what x = X + U c cannot follow.
void check_bases(const Scene& scene);

// nullptr where no body has a basis. Of the parts, everything but springs has been made. Throws InputError.
std::unique_ptr<Reduction> make_reduction(const Parts& parts, const Scene& scene);

// One line of what a scene has: "basis beam", "derivatives, 20 coordinates for 7500 unknowns".
TermInfo basis_info(const Body& body, int D);

}  // namespace sim
