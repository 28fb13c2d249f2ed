// The keys of the window.
#pragma once

#include <optional>

#include "app/panel/panel.h"
#include "render/window.h"

namespace app {

// What the key that was pressed asks for, if it asks for anything.
std::optional<Action> action_of(const render::WindowEvent& event);

}  // namespace app
