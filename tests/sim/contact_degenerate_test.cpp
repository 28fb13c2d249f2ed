// The cases of [Erleben 2018, Methodology for assessing mesh-based contact point methods], in which the direction of a
// contact is not told by a face: nothing passes, and every step is solved.
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

Mesh of_tets(const std::vector<Vec3>& points, const std::vector<std::array<int, 4>>& tets) {
  Mesh mesh;
  mesh.X.resize(3, static_cast<Eigen::Index>(points.size()));
  mesh.elements.resize(4, static_cast<Eigen::Index>(tets.size()));
  for (std::size_t i = 0; i < points.size(); ++i) mesh.X.col(static_cast<Eigen::Index>(i)) = points[i];
  for (std::size_t e = 0; e < tets.size(); ++e) {
    auto [a, b, c, d] = tets[e];
    if ((points[b] - points[a]).cross(points[c] - points[a]).dot(points[d] - points[a]) < 0) std::swap(c, d);
    mesh.elements.col(static_cast<Eigen::Index>(e)) << a, b, c, d;
  }
  return mesh;
}

// On their base at y = 0, 1 m high, sharp above: points, or ridges along z.
Mesh spikes(const std::vector<Vec3>& feet) {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> tets;
  for (const Vec3& foot : feet) {
    const int n = static_cast<int>(points.size());
    for (const Vec3& corner : {Vec3(-0.3, 0, -0.2), Vec3(0.3, 0, -0.2), Vec3(0, 0, 0.4), Vec3(0, 1, 0)})
      points.push_back(foot + corner);
    tets.push_back({n, n + 1, n + 2, n + 3});
  }
  return of_tets(points, tets);
}
Mesh ridges(const std::vector<double>& places) {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> tets;
  for (const double x : places) {
    const int n = static_cast<int>(points.size());
    for (const double z : {-0.5, 0.5})
      for (const Vec3& corner : {Vec3(x - 0.4, 0, z), Vec3(x + 0.4, 0, z), Vec3(x, 1, z)}) points.push_back(corner);
    tets.insert(tets.end(), {{n, n + 1, n + 2, n + 3}, {n + 1, n + 2, n + 3, n + 4}, {n + 2, n + 3, n + 4, n + 5}});
  }
  return of_tets(points, tets);
}
Mesh upside_down(Mesh mesh, const Vec3& axis) {
  rotate(mesh, axis, 180);
  return mesh;
}

struct SharpCase {
  const char* name;
  Mesh low, top;
  double meet;  // m: how high the origin of the upper one is where they touch
};

std::vector<SharpCase> sharp_cases() {
  const std::vector<Vec3> feet = {{-1, 0, -1}, {0, 0, -1}, {1, 0, -1}, {-1, 0, 0}, {0, 0, 0},
                                  {1, 0, 0},   {-1, 0, 1}, {0, 0, 1},  {1, 0, 1}};
  Mesh half_over = generate_box({1, 0.5, 1}, {2, 1, 2}, {1, 1, 1}, ElementKind::tet4), cliff = half_over;
  translate(half_over, {0.5, 0, 0});
  return {{"vertex on vertex", spikes({{0, 0, 0}}), upside_down(spikes({{0, 0, 0}}), {0, 0, 1}), 2},
          {"edge on edge", ridges({0}), upside_down(ridges({0}), Vec3(1, 0, 1).normalized()), 2},
          {"parallel edges", ridges({0}), upside_down(ridges({0}), {0, 0, 1}), 2},
          {"spikes", spikes(feet), upside_down(spikes(feet), {0, 0, 1}), 2},
          {"wedge", ridges({-0.4, 0.4}), upside_down(ridges({0}), {0, 0, 1}), 1},
          {"cliff", cliff, half_over, 0.5}};
}

TEST(ContactDegenerate, SharpThingsOnSharpThings) {
  for (const SharpCase& it : sharp_cases()) {
    SCOPED_TRACE(it.name);
    Scene scene = test::two_boxes(1, 0);
    scene.bodies[0].mesh = it.low;
    scene.bodies[1].mesh = it.top;
    translate(scene.bodies[1].mesh, {0, it.meet + 0.01, 0});
    scene.bodies[1].velocity = {0, -2, 0};
    test::Stepped run(scene);
    int most = 0, touching = 0;
    for (int k = 0; k < 30; ++k) {
      run.steps(1);
      most = std::max(most, run.last.newton);
      touching += run.system.contacts(run.state)[0].pairs > 0;
      ASSERT_EQ(test::count_crossings(scene, run.state.x, false), 0) << "step " << k;
      ASSERT_EQ(test::count_swallowed(scene, run.state.x), 0) << "step " << k;
    }
    std::printf("%s: %d iterations at most, %d steps of 30 in contact\n", it.name, most, touching);
    EXPECT_GT(touching, 0);
  }
}

}  // namespace
}  // namespace sim
