// The spring by which a mouse pulls a body.
#pragma once

#include "app/session/input.h"
#include "sim/scene.h"

namespace app {

// Its stiffness is a fifth of the stiffest material's Young's modulus times the body's length: pulled by its own
// length, a body stretches visibly, and is not torn. Throws SceneError when there is no such body.
sim::Spring spring_of_pull(const sim::Scene& scene, const Pull& pull);

}  // namespace app
