// Contact: a body meets another of its kind, without damping or friction, so that the energy must not grow. They
// do not lie straight above each other, so that edges and corners meet faces.
#include "app/stress/extremes.h"
#include "sim/mesh/transform.h"

namespace app {
namespace {

// A second body, moved aside by a share of the size and up by half of it from where the first one ends.
void add_another(sim::Scene& scene) {
  for (sim::Body& body : scene.bodies) body.damping = {};
  sim::Body other = scene.bodies.front();
  other.name = "other";
  const Eigen::VectorXd extent = other.mesh.X.rowwise().maxCoeff() - other.mesh.X.rowwise().minCoeff();
  const double size = extent.maxCoeff();
  sim::translate(other.mesh, {0.13 * size, extent[1] + 0.5 * size, 0.07 * size});
  scene.bodies = {scene.bodies.front(), other};
  scene.contacts = {sim::Contact{}};
}

Extreme meeting(const std::string& name, bool quick, const std::function<void(sim::Scene&)>& move) {
  return {"contact", name, quick, true, [move](sim::Scene& scene) {
            add_another(scene);
            move(scene);
          }};
}

void close_in(sim::Scene& scene, double speed) {
  scene.bodies[0].velocity = {0, speed / 2, 0};
  scene.bodies[1].velocity = {0, -speed / 2, 0};
}

}  // namespace

std::vector<Extreme> contact_extremes() {
  return {meeting("meets another, 1 m/s", false, [](sim::Scene& scene) { close_in(scene, 1); }),
          meeting("meets another, 40 m/s", false, [](sim::Scene& scene) { close_in(scene, 40); }),
          meeting("two on a plane", false, [](sim::Scene& scene) {
            scene.world.gravity = {0, -9.81, 0};
            const auto heights = scene.bodies[0].mesh.X.row(1);
            const double below =
                heights.minCoeff() - 0.1 * (scene.bodies[1].mesh.X.row(1).maxCoeff() - heights.minCoeff());
            scene.obstacles = {{sim::Plane{{0, below, 0}, {0, 1, 0}}}};
          })};
}

}  // namespace app
