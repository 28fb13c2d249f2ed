// The surface of an obstacle in the picture.
#pragma once

#include "app/scene/document.h"
#include "render/frame.h"

namespace app {

// All that is the same in every frame.
render::Surface still_surface(const sim::Obstacle& obstacle, const ObstacleMesh& mesh, const Vec3& origin, bool smooth);

// x, y, z of its vertices from the origin.
std::vector<float> vertices(const sim::RigidSurface& surface, const Vec3& origin);

}  // namespace app
