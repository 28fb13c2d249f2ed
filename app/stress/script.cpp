// Scripts: ends of the body that are moved faster than the step resolves, and a fall.
#include "app/stress/extremes.h"

namespace app {
namespace {

// The high end goes through the poses at these times and is back at the last; the low end is held. Both are let go
// when it is back.
Extreme moved(const std::string& name, bool quick,
              const std::function<std::vector<sim::Keyframe>(const Ends&)>& motion) {
  return {"script", name, quick, false, [motion](sim::Scene& scene) {
            const Ends ends = ends_of(scene);
            sim::Pin held, driven;
            held.where = ends.low;
            driven.where = ends.high;
            driven.motion = motion(ends);
            held.release = driven.release = driven.motion.back().t;
            scene.bodies.front().pins = {held, driven};
          }};
}

sim::Keyframe pose(double t, const Ends& ends, double lengths, double degrees) {
  sim::Keyframe k;
  k.t = t;
  k.translate = lengths * ends.length * ends.along;
  k.axis = ends.along;
  k.centre = ends.middle;
  k.degrees = degrees;
  return k;
}

void drop(sim::Scene& scene) {
  const sim::Mesh& mesh = scene.bodies.front().mesh;
  scene.world.gravity = {0, -9.81, 0};
  sim::Vec3 point = sim::Vec3::Zero();
  point[1] = mesh.X.row(1).minCoeff() - 100;
  scene.obstacles = {{sim::Plane{point, {0, 1, 0}}, 0.5}};
  for (sim::Body& body : scene.bodies) {
    body.damping = {};
    for (sim::MaterialSpec& material : body.materials) material.young *= 10;
  }
  set_step(scene, 1.0 / 24);
}

}  // namespace

std::vector<Extreme> script_extremes() {
  return {
      moved("torn to 6 lengths in 1/60 s", true,
            [](const Ends& e) {
              return std::vector{pose(0, e, 0, 0), pose(1 / 60.0, e, 5, 0), pose(0.5, e, 5, 0), pose(0.6, e, 0, 0)};
            }),
      moved("twisted by 720 degrees in 1/60 s", false,
            [](const Ends& e) {
              return std::vector{pose(0, e, 0, 0), pose(1 / 60.0, e, 0, 720), pose(0.5, e, 0, 720), pose(1, e, 0, 0)};
            }),
      moved(
          "crushed through itself in 1/60 s", false,
          [](const Ends& e) {
            return std::vector{pose(0, e, 0, 0), pose(1 / 60.0, e, -1.5, 0), pose(0.5, e, -1.5, 0), pose(0.6, e, 0, 0)};
          }),
      {"script", "dropped 100 m, h = 1/24 s", true, true, drop},
  };
}

}  // namespace app
