// The caption of a frame: text with {names} in the place of live values.
#pragma once

#include <string>
#include <vector>

#include "app/frame_sink.h"
#include "sim/system.h"

namespace app {

// t [s], frame, steps taken, step = h [s], energy = kinetic + elastic + potential [J], iterations of Newton in the last
// step, min_J = the smallest det F after it, nodes, elements.
const std::vector<std::string>& known_caption_names();

// The {names} in a text, in their order.
std::vector<std::string> caption_names(const std::string& text);

// The text with the values of its names. What is not known stays as it is.
std::string caption(const std::string& text, const sim::System& system, const Moment& moment);

}  // namespace app
