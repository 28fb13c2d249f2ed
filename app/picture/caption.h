// The caption of a frame: text with {names} in the place of live values.
#pragma once

#include <string>

#include "app/picture/moment.h"
#include "sim/system.h"

namespace app {

// The text with the values of its names (app/scene/caption_names.h). What is not known stays as it is.
std::string caption(const std::string& text, const sim::System& system, const Moment& moment);

}  // namespace app
