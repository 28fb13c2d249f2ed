// How a mouse moves a camera. Drags are shares of the picture's height, right and down positive.
#pragma once

#include "app/session/input.h"
#include "render/frame.h"

namespace app {

// About the target; stops short of looking straight along `up`. In the plane it pans.
MoveCamera orbit(const render::Camera& camera, double right, double down);
// What was under the mouse stays under it (at the target's distance).
MoveCamera pan(const render::Camera& camera, double right, double down);
// Nearer by a tenth for each notch.
MoveCamera zoom(const render::Camera& camera, double notches);

// The camera after the move.
render::Camera moved(render::Camera camera, const MoveCamera& move);

}  // namespace app
