// Bodies that rest on each other: gaps, forces and pressures that are known.
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

constexpr double half_turn = 3.14159265358979323846;

// Five boxes of 1 m, each held up by nothing but the one below.
Scene stack(int dimension) {
  Scene scene;
  scene.dimension = dimension;
  scene.time.integrator = "static";
  scene.solver.tolerance = 1e-7;
  double low = 0;
  for (int k = 0; k < 5; ++k) {
    Body body = test::box_body("box" + std::to_string(k), {1, 1, 1}, 2, {0, low, 0});
    if (dimension == 2) {
      body.mesh = generate_rectangle({1, 1}, {2, 2}, {1, 1}, ElementKind::tri3);
      translate(body.mesh, {0, low, 0});
    }
    body.materials = {MaterialSpec{"linear", 1e6, 0, 1000, ""}};
    body.pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, dimension == 2 ? "x" : "xz", {}, {}}};
    if (k == 0) body.pins.push_back(Pin{InGroup{"bottom"}, "y", {}, {}});
    scene.bodies.push_back(body);
    low += 1 + 0.7e-3;
  }
  scene.contacts = {Contact{}};
  return scene;
}

// Each gap carries the weight of the boxes above it, and is as large as the barrier says at that pressure: -b'(s) =
// p/kappa at 4, 3, 2, 1 times 9810 Pa. In space edges carry a part, and where meshes lie aligned they are counted at
// their ends as well: the gap is wider there, never smaller.
TEST(ContactRest, GapsInAStackCarryTheWeightAbove) {
  const double gaps[] = {0.68, 0.72, 0.77, 0.83};  // of dh
  for (const int dimension : {2, 3}) {
    const Scene scene = stack(dimension);
    test::Stepped run(scene);
    run.steps(1);
    EXPECT_EQ(test::count_crossings(scene, run.state.x), 0);
    for (const ContactReport& report : run.system.contacts(run.state)) {
      const int below = report.first.back() - '0', above = report.second.back() - '0';
      if (above != below + 1) {
        EXPECT_EQ(report.pairs, 0);
        continue;
      }
      const double gap = report.gap / 1e-3;
      std::printf("in %d dimensions, under %d boxes: %.3f of dh\n", dimension, 4 - below, gap);
      if (dimension == 2)
        EXPECT_NEAR(gap, gaps[below], 0.006);
      else
        EXPECT_TRUE(gap > gaps[below] - 0.006 && gap < 1) << gap;
      EXPECT_NEAR(report.force.y(), -9810 * (4 - below), 1e-3 * 9810) << report.first;
    }
  }
}

// The squeeze of a quarter of a sphere of 0.5 m against what is below it, and the force on the whole of it.
struct Squeeze {
  double approach, force;  // m, N
};
constexpr double ball_radius = 0.5, ball_poisson = 0.3, ball_young = 1e6,
                 ball_star = ball_young / (1 - ball_poisson * ball_poisson);
constexpr double squeezed = 0.01;  // m, of each sphere

Body half_sphere(const std::string& name, int cells) {
  Body body;
  body.name = name;
  body.mesh = test::quarter_of_half_sphere(ball_radius, cells, 2);
  body.materials = {MaterialSpec{"linear", ball_young, ball_poisson, 1000, ""}};
  body.pins = {Pin{Box{{-1e-9, -2, -9}, {1e-9, 2, 9}}, "x", {}, {}},
               Pin{Box{{-2, -1e-9, -9}, {2, 1e-9, 9}}, "y", {}, {}}};
  return body;
}

Pin driven(double low, double high, double way) {
  Pin pin{Box{{-2, -2, low - 1e-9}, {2, 2, high + 1e-9}}, "z", {}, {}};
  if (way != 0) {
    pin.motion = {Keyframe{}, Keyframe{}};
    pin.motion[1].t = 1;
    pin.motion[1].translate = {0, 0, way};
  }
  return pin;
}

Squeeze squeeze(bool two_spheres) {
  const double start = 1e-5;
  Scene scene;
  scene.world.gravity = {0, 0, 0};
  scene.time.integrator = "static";
  scene.time.fps = 2;
  const int cells = 8;
  scene.bodies = {half_sphere("upper", cells)};
  translate(scene.bodies[0].mesh, {0, 0, ball_radius + start});
  scene.bodies[0].pins.push_back(driven(ball_radius + start, 9, -squeezed));
  if (two_spheres) {
    scene.bodies.push_back(half_sphere("lower", cells));
    rotate(scene.bodies[1].mesh, {1, 1, 0}, 180);
    translate(scene.bodies[1].mesh, {0, 0, -ball_radius});
    scene.bodies[1].pins.push_back(driven(-9, -ball_radius, squeezed));
  } else {
    scene.bodies.push_back(test::box_body("slab", {2, 2, 0.1}, 1, {-1.1, -0.8, -0.1}, 1e6));
    scene.bodies[1].pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, "xyz", {}, {}}};
  }
  scene.contacts = {Contact{{}, 0, 1e-5, {}, {}}};
  scene.solver.tolerance = 1e-7;
  test::Stepped run(scene);
  run.steps(2);
  const ContactReport report = run.system.contacts(run.state)[0];
  return {squeezed * (two_spheres ? 2 : 1) + report.gap - start, 4 * report.force.z()};
}

double hertz(double approach) {
  return 4.0 / 3 * ball_star * std::sqrt(ball_radius) * std::pow(approach, 1.5);
}

// hertz(d + F f/(pi E)) = F, with f of the radius a of the area that touches.
double two_plates(double approach) {
  double F = hertz(approach);
  for (int k = 0; k < 50; ++k) {
    const double a = std::cbrt(0.75 * F * ball_radius / ball_star), r2 = a * a + 4 * ball_radius * ball_radius;
    const double f = 2 * (1 + ball_poisson) * ball_radius * ball_radius / std::pow(r2, 1.5) +
                     (1 - ball_poisson * ball_poisson) / std::sqrt(r2);
    F = hertz(approach + F * f / (half_turn * ball_young));
  }
  return F;
}

// F = 4/3 E* sqrt(R) d^1.5 [Hertz 1882] for bodies that go on for ever. A sphere between two plates, which the half of
// one with a plane middle is, gives way a little less: by F f/(pi E) for each plate. [Tatara 1991]
TEST(ContactRest, SpheresPushBackAsHertzSays) {
  const Squeeze plane = squeeze(false), two = squeeze(true);
  const double expected = two_plates(plane.approach);
  std::printf("sphere on plane %.4g N, two spheres %.4g N, between plates %.4g N, Hertz %.4g N\n", plane.force,
              two.force, expected, hertz(plane.approach));
  EXPECT_NEAR(plane.force / expected, 1, 0.02);
  EXPECT_NEAR(two.force / two_plates(two.approach / 2), 1, 0.02);
  EXPECT_NEAR(hertz(squeezed), 1036, 1);
}

}  // namespace
}  // namespace sim
