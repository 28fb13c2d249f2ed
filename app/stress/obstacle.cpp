// Obstacles: a body dropped, thrown and squeezed, without damping or friction, so that the energy must not grow.
#include "app/stress/extremes.h"

namespace app {
namespace {

// What all bodies of a scene fill at rest.
struct Bounds {
  sim::Vec3 low = sim::Vec3::Constant(1e300), high = sim::Vec3::Constant(-1e300);

  explicit Bounds(const sim::Scene& scene) {
    for (const sim::Body& body : scene.bodies) {
      sim::Vec3 least = sim::Vec3::Zero(), most = least;
      least.head(body.mesh.dimension()) = body.mesh.X.rowwise().minCoeff();
      most.head(body.mesh.dimension()) = body.mesh.X.rowwise().maxCoeff();
      low = low.cwiseMin(least);
      high = high.cwiseMax(most);
    }
  }
  double size() const { return (high - low).maxCoeff(); }
  sim::Vec3 centre() const { return (low + high) / 2; }
  // Half a body below, and what the highest point of an obstacle is called.
  sim::Vec3 below() const { return {centre()[0], low[1] - 0.5 * size(), centre()[2]}; }
};

sim::Obstacle floor_at(const sim::Vec3& point) {
  return {sim::Plane{point, {0, 1, 0}}};
}

// As large as the body, and not quite below its middle.
sim::Obstacle ball_below(const sim::Vec3& point, double size) {
  const double radius = size / 2;
  return {sim::Sphere{point + sim::Vec3(0.1 * size, -radius, 0), radius}};
}

Extreme met(const std::string& name, bool quick, const std::function<void(sim::Scene&, const Bounds&)>& place) {
  return {"obstacle", name, quick, true, [place](sim::Scene& scene) {
            for (sim::Body& body : scene.bodies) body.damping = {};
            place(scene, Bounds(scene));
          }};
}

void fall(sim::Scene& scene) {
  scene.world.gravity = {0, -9.81, 0};
}

void fly(sim::Scene& scene) {
  for (sim::Body& body : scene.bodies) body.velocity = {0, -40, 0};
}

// From two fifths of its height it wants to grow, and there is room for half of it.
void squeeze(sim::Scene& scene, const Bounds& bounds) {
  for (sim::Body& body : scene.bodies) {
    body.start.shape = "squashed";
    body.start.amount = 0.4;
    body.start.direction = sim::Vec3::UnitY();
  }
  const double quarter = (bounds.high[1] - bounds.low[1]) / 4;
  scene.obstacles = {{sim::Plane{bounds.centre() - quarter * sim::Vec3::UnitY(), {0, 1, 0}}},
                     {sim::Plane{bounds.centre() + quarter * sim::Vec3::UnitY(), {0, -1, 0}}}};
}

}  // namespace

std::vector<Extreme> obstacle_extremes() {
  return {met("dropped on a plane", true,
              [](sim::Scene& scene, const Bounds& bounds) {
                fall(scene);
                scene.obstacles = {floor_at(bounds.below())};
              }),
          met("dropped on a sphere", false,
              [](sim::Scene& scene, const Bounds& bounds) {
                fall(scene);
                scene.obstacles = {ball_below(bounds.below(), bounds.size())};
              }),
          met("thrown at a plane, 40 m/s", true,
              [](sim::Scene& scene, const Bounds& bounds) {
                fly(scene);
                scene.obstacles = {floor_at(bounds.below())};
              }),
          met("thrown at a sphere, 40 m/s", false,
              [](sim::Scene& scene, const Bounds& bounds) {
                fly(scene);
                scene.obstacles = {ball_below(bounds.below(), bounds.size())};
              }),
          met("squeezed by planes", false, squeeze)};
}

}  // namespace app
