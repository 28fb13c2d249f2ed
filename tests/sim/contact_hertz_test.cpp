// Round bodies against a flat one: what Hertz (1882) found for a line, and for an impact.
#include "tests/sim/contact_support.h"
#include "tests/sim/hertz.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

MaterialSpec rubber() {
  return {"linear", test::ball_young, test::ball_poisson, 1000, ""};
}

Body held_slab(const Mesh& mesh) {
  Body slab;
  slab.name = "slab";
  slab.mesh = mesh;
  slab.materials = {rubber()};
  slab.pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, mesh.dimension() == 2 ? "xy" : "xyz", {}, {}}};
  return slab;
}

// Points of a square or a cube around the origin are drawn in, so that their largest coordinate becomes their distance.
void make_round(Mesh& mesh, const Vec3& centre) {
  for (Eigen::Index i = 0; i < mesh.X.cols(); ++i) {
    const Eigen::VectorXd cube = mesh.X.col(i) - centre.head(mesh.dimension());
    mesh.X.col(i) = cube.norm() > 0
                        ? Eigen::VectorXd(test::ball_radius * cube.lpNorm<Eigen::Infinity>() / cube.norm() * cube)
                        : Eigen::VectorXd(cube);
  }
}

// A quarter of a disk, 0 <= x and y <= 0, driven down by its middle onto a slab.
Scene cylinder(double approach) {
  Scene scene;
  scene.dimension = 2;
  scene.world.gravity = {0, 0, 0};
  scene.time.integrator = "static";
  scene.time.fps = 2;
  scene.solver.tolerance = 1e-7;
  Body disk;
  disk.name = "disk";
  disk.mesh = generate_rectangle({1, 1}, {48, 48}, {2.5, 2.5}, ElementKind::quad4);
  make_round(disk.mesh, {0, 1, 0});
  const double start = 1e-5;
  translate(disk.mesh, {0, test::ball_radius + start, 0});
  disk.materials = {rubber()};
  Pin middle{Box{{-1, test::ball_radius + start - 1e-9, -1}, {1, 1, 1}}, "y", {}, {}};
  middle.motion = {Keyframe{}, Keyframe{}};
  middle.motion[1].t = 1;
  middle.motion[1].translate = {0, -approach, 0};
  disk.pins = {Pin{Box{{-1e-9, -1, -1}, {1e-9, 1, 1}}, "x", {}, {}}, middle};
  Mesh slab = generate_rectangle({2, 0.1}, {1, 1}, {1, 1}, ElementKind::quad4);
  translate(slab, {-1.1, -0.1, 0});
  scene.bodies = {disk, held_slab(slab)};
  scene.contacts = {Contact{{}, 0, 1e-5, {}, {}}};
  return scene;
}

// The pressure along a line of contact is p0 sqrt(1 - (x/a)^2), with a = sqrt(4 F R/(pi E*)), p0 = sqrt(F E*/(pi R)) at
// a force F a metre: 24.1 mm and 26.4 kPa at 1 kN/m.
TEST(ContactHertz, PressureOfACylinder) {
  test::Stepped run(cylinder(2.28e-3));
  run.steps(2);
  const double F = 2 * run.system.contacts(run.state)[0].force.y();
  const double a = std::sqrt(4 * F * test::ball_radius / (std::numbers::pi * test::ball_star)),
               p0 = std::sqrt(F * test::ball_star / (std::numbers::pi * test::ball_radius));
  EXPECT_NEAR(F, 1000, 50);
  EXPECT_NEAR(std::sqrt(4 * 1000 * test::ball_radius / (std::numbers::pi * test::ball_star)), 0.0241, 1e-4);
  EXPECT_NEAR(std::sqrt(1000 * test::ball_star / (std::numbers::pi * test::ball_radius)), 2.64e4, 100);
  // p^2 is a line over x^2; the node on the axis has a part of the plane of symmetry.
  const Eigen::VectorXd pressure = run.system.node_values(run.state, Quantity::pressure);
  const BodyRange& disk = run.system.bodies()[0];
  double n = 0, s = 0, ss = 0, q = 0, sq = 0, outside = 0;
  for (int i = 0; i < disk.node_count; ++i) {
    const double x = run.state.x[2 * i], p = pressure[i];
    if (x > 1.1 * a) outside = std::max(outside, p);
    if (p == 0 || x < 1e-9 || x > 0.9 * a) continue;
    n += 1, s += x * x, ss += x * x * x * x, q += p * p, sq += x * x * p * p;
  }
  ASSERT_GE(n, 8);
  const double slope = (n * sq - s * q) / (n * ss - s * s), height = (q - slope * s) / n;
  std::printf("%.0f N/m: half width %.4f m of %.4f m, largest pressure %.0f Pa of %.0f Pa, by %.0f nodes\n", F,
              std::sqrt(-height / slope), a, std::sqrt(height), p0, n);
  EXPECT_NEAR(std::sqrt(-height / slope) / a, 1, 0.03);
  EXPECT_NEAR(std::sqrt(height) / p0, 1, 0.03);
  EXPECT_EQ(outside, 0);
}

// A quarter of a ball, finest at its lowest point, falls on a slab at 0.5 m/s without gravity.
Scene falling_ball(const char* scheme, int fps) {
  Scene scene;
  scene.world.gravity = {0, 0, 0};
  scene.time.integrator = scheme;
  scene.time.fps = fps;
  Body ball;
  ball.name = "ball";
  ball.mesh = generate_box({1, 1, 2}, {8, 8, 16}, {1.5, 1.5, 1.5}, ElementKind::hex8);
  make_round(ball.mesh, {0, 0, 1});
  translate(ball.mesh, {0, 0, test::ball_radius + 1e-3});
  ball.materials = {rubber()};
  ball.pins = {Pin{Box{{-1e-9, -2, -9}, {1e-9, 2, 9}}, "x", {}, {}},
               Pin{Box{{-2, -1e-9, -9}, {2, 1e-9, 9}}, "y", {}, {}}};
  ball.velocity = {0, 0, -0.5};
  Mesh slab = test::box_mesh({2, 2, 0.1}, {-1.1, -0.8, -0.1});
  scene.bodies = {ball, held_slab(slab)};
  scene.contacts = {Contact{{}, 0, 1e-4, {}, {}}};
  return scene;
}

// What a spring of the force F(d), of that stiffness at every depth, does to a mass m that comes with v.
struct Bounce {
  double depth = 0, contact = 0, force = 0;  // m, s, N
};
template <class F>
Bounce bounce(const F& force, double m, double v) {
  const double dt = 1e-5;
  Bounce it;
  for (double d = 0; d >= 0; it.contact += dt) {
    const double f = force(d);
    v -= f / m * dt;
    d += v * dt;
    it.depth = std::max(it.depth, d);
    it.force = std::max(it.force, f);
  }
  return it;
}

// The ball is slow beside its waves, so that it is pushed back as at rest: by Hertz's force it would sink by
// (15/16 m v^2/(E* sqrt(R)))^0.4 = 30.2 mm, for 0.178 s, with 5430 N at most. Pressed so deep a sphere is stiffer than
// that, as one between plates is.
TEST(ContactHertz, ImpactOfASphere) {
  const int fps = 480;
  test::Stepped run(falling_ball("bdf2", fps));
  const double m = 4 * run.system.mass(0), v = 0.5;
  EXPECT_NEAR(m, 1000 * 4.0 / 3 * std::numbers::pi * std::pow(test::ball_radius, 3), 0.02 * m);
  const Bounce flat = bounce(test::hertz, m, v), expected = bounce(test::two_plates, m, v);
  EXPECT_NEAR(flat.depth, 0.0302, 2e-4);
  EXPECT_NEAR(flat.contact, 0.178, 2e-3);
  EXPECT_NEAR(flat.force, 5430, 50);
  const auto height = [&] {
    const BodyRange& ball = run.system.bodies()[0];
    const Mass& mass = parts_of(run.system).model.masses[0];
    double z = 0;
    for (int i = 0; i < ball.node_count; ++i) z += mass.nodal()[i] * run.state.x[3 * i + 2] / mass.total();
    return z;
  };
  const double touching = height() - 1e-3;
  Bounce it;
  for (int k = 0; k < fps / 4; ++k) {
    run.steps(1);
    const ContactReport report = run.system.contacts(run.state)[0];
    it.depth = std::max(it.depth, touching - height());
    it.force = std::max(it.force, 4 * report.force.z());
    it.contact += report.force.z() > 0 ? 1.0 / fps : 0;
  }
  std::printf("deepest %.4f m of %.4f m, contact %.3f s of %.3f s, largest force %.0f N of %.0f N\n", it.depth,
              expected.depth, it.contact, expected.contact, it.force, expected.force);
  EXPECT_NEAR(it.depth / expected.depth, 1, 0.04);
  EXPECT_NEAR(it.contact / expected.contact, 1, 0.04);
  EXPECT_NEAR(it.force / expected.force, 1, 0.08);
}

}  // namespace
}  // namespace sim
