// The caption of a frame: text with {names} in the place of live values.
#pragma once

#include <string>

#include "app/frame_sink.h"
#include "sim/system.h"

namespace app {

// {t} time [s], {frame}, {step} = h [s], {energy} kinetic + elastic + potential [J], {iterations} of Newton in the last
// step. Anything else stays as it is.
std::string caption(const std::string& text, const sim::System& system, const Moment& moment);

}  // namespace app
