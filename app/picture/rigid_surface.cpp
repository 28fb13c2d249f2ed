#include "app/picture/rigid_surface.h"

namespace app {

std::vector<float> vertices(const sim::RigidSurface& surface, const Vec3& origin) {
  std::vector<float> all;
  for (const auto& node : surface.X.colwise()) {
    Vec3 x = Vec3::Zero();
    x.head(node.size()) = node;
    x -= origin;
    for (const double number : x) all.push_back(static_cast<float>(number));
  }
  return all;
}

render::Surface still_surface(const sim::Obstacle& obstacle, const ObstacleMesh& mesh, const Vec3& origin,
                              bool smooth) {
  const auto& shape = std::get<sim::RigidSurface>(obstacle.shape);
  render::Surface still;
  still.name = obstacle.name;
  still.flat = shape.X.rows() == 2;
  still.round = smooth && !still.flat;
  still.crease = 60;  // as of bodies
  still.colour = {0.62F, 0.66F, 0.71F};
  for (const int node : mesh.triangles.reshaped()) still.triangles.push_back(static_cast<std::uint32_t>(node));
  if (still.flat)
    for (const int node : shape.faces.reshaped()) still.outline.push_back(static_cast<std::uint32_t>(node));
  still.rest = vertices(shape, origin);
  return still;
}

}  // namespace app
