// Random bodies thrown at each other, one scene for each seed: for the tests of contact.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/body/random.h"
#include "tests/sim/contact_support.h"

namespace sim::test {

struct Drop {
  Scene scene;
  bool with_itself = false;  // each body touches itself as well
  double speed = 0;          // m/s, at which bodies meet
  int steps = 25;
};

namespace drops {

inline double log_uniform(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}
inline int pick(Random& random, int count) {
  return static_cast<int>(random.uniform(0, count));
}
inline Vec3 direction(Random& random) {
  for (;;) {
    const Vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (v.norm() < 1 && v.norm() > 0.1) return v.normalized();
  }
}

// A block, a flat slab, a thin rod, a spike, a sheet.
inline Mesh shape(Random& random, bool& is_sheet) {
  const int kind = pick(random, 5), n = 1 + pick(random, 2);
  is_sheet = kind == 4;
  if (is_sheet) return generate_sheet({1, random.uniform(0.3, 1)}, {n + 2, n + 1}, {1, 1}, ElementKind::tri3);
  const Vec3 size = kind == 1   ? Vec3(1, random.uniform(0.05, 0.2), 1)
                    : kind == 2 ? Vec3(1, random.uniform(0.05, 0.2), random.uniform(0.05, 0.2))
                                : Vec3(1, random.uniform(0.5, 1), random.uniform(0.5, 1));
  const std::array<int, 3> cells = kind == 1   ? std::array{n + 1, 1, n + 1}
                                   : kind == 2 ? std::array{3 * n, 1, 1}
                                               : std::array{n, n, n};
  Mesh mesh = generate_box(size, cells, {1, 1, 1}, ElementKind::tet4);
  if (kind == 3)  // drawn to a point along x
    for (Eigen::Index i = 0; i < mesh.X.cols(); ++i) mesh.X.col(i).tail<2>() *= 1.02 - mesh.X(0, i);
  return mesh;
}

inline Body body(Random& random, int number, double young) {
  bool is_sheet;
  Body it;
  it.name = std::string(1, static_cast<char>('a' + number));
  it.mesh = shape(random, is_sheet);
  const double size = log_uniform(random, 0.1, 1);
  scale(it.mesh, Vec3::Constant(size));
  const Vec3 middle = it.mesh.X.rowwise().mean();
  translate(it.mesh, -middle);
  rotate(it.mesh, direction(random), random.uniform(0, 360));
  if (is_sheet) it.thickness = size * random.uniform(0.002, 0.02);
  it.materials = {MaterialSpec{"stable-neo-hookean", young, random.uniform(0, is_sheet ? 0.4 : 0.49), 1000, ""}};
  return it;
}

inline double radius_of(const Body& body) {
  return body.mesh.X.colwise().norm().maxCoeff();
}

// What lies under them: nothing, a plane or a surface.
inline void add_ground(Random& random, double y, Scene& scene) {
  const int kind = pick(random, 3);
  if (kind == 0) return;
  Obstacle ground = surface_obstacle(box_mesh({20, 1, 20}, {-10.3, y - 1, -9.8}));
  if (kind == 1) ground.shape = Plane{{0, y, 0}, {0, 1, 0}};
  ground.friction = pick(random, 2) * random.uniform(0, 1);
  scene.obstacles = {ground};
}

}  // namespace drops

// Two or three bodies that meet within a few steps, at up to 50 m/s, with steps of 1 ms to 1 s and Young's moduli of
// 1e3 to 1e9 Pa. Equal seeds give equal scenes on every machine.
inline Drop drop(std::uint64_t seed) {
  Random random(seed);
  Drop it;
  Scene& scene = it.scene;
  scene.time.fps = static_cast<int>(std::lround(1 / drops::log_uniform(random, 1e-3, 1)));
  constexpr const char* schemes[] = {"backward-euler", "backward-euler", "bdf2", "tr-bdf2", "trapezoidal"};
  scene.time.integrator = schemes[drops::pick(random, 5)];
  it.speed = drops::log_uniform(random, 0.5, 50);
  const double young = drops::log_uniform(random, 1e3, 1e9);
  const int count = 2 + drops::pick(random, 2);
  const Vec3 side = drops::direction(random);
  double low = 0;
  for (int k = 0; k < count; ++k) {
    Body body = drops::body(random, k, std::clamp(young * drops::log_uniform(random, 0.03, 30), 1e3, 1e9));
    if (k > 0) {  // from both sides of the first
      const Vec3 from = k == 1 ? side : Vec3(-side);
      const double gap = std::min(1.0, 3 * it.speed / scene.time.fps) * random.uniform(0.01, 1);
      translate(body.mesh, (drops::radius_of(body) + drops::radius_of(scene.bodies[0]) + gap) * from);
      body.velocity = it.speed * (drops::direction(random) / 4 - from).normalized();
      body.spin = Spin{drops::direction(random), random.uniform(-10, 10)};
    }
    scene.bodies.push_back(body);
    low = std::min(low, body.mesh.X.row(1).minCoeff());
  }
  drops::add_ground(random, low - random.uniform(0.001, 0.1), scene);
  it.with_itself = drops::pick(random, 4) == 0;
  scene.contacts = {Contact{{}, drops::pick(random, 2) * random.uniform(0, 1), {}, {}, {}}};
  if (it.with_itself)
    for (const Body& body : scene.bodies) scene.contacts.push_back(Contact{{body.name, body.name}, 0.2, {}, {}, {}});
  scene.seed = seed;
  return it;
}

}  // namespace sim::test
