// What becomes of surfaces as people have them: each is a body of the right volume, or refused with its reason.
#include <functional>

#include "sim/fill/fill.h"
#include "tests/sim/mesh_support.h"
#include "tests/sim/surfaces.h"

namespace sim::test {
namespace {

constexpr double whole_ball = 4 * std::numbers::pi / 3;

struct DirtySurface {
  const char* name;
  Mesh surface;
  double size;
  double volume, share;  // m^3, and how far from it; 0: it is refused
  const char* reason;    // of the refusal
  std::function<int(const Filling&)> count = {};
  int counted = 0;
};

Mesh scaled(Mesh mesh, double by) {
  mesh.X *= by;
  return mesh;
}

Mesh moved(Mesh mesh, const Vec3& by) {
  mesh.X.colwise() += by;
  return mesh;
}

Mesh turned_over(Mesh mesh, int from, int count) {
  turn_over(mesh, from, count);
  return mesh;
}

// Every triangle with three vertices of its own.
Mesh soup_of(const Mesh& mesh) {
  Mesh soup = mesh;
  soup.X.resize(3, 3 * mesh.element_count());
  for (int t = 0; t < mesh.element_count(); ++t)
    for (int i = 0; i < 3; ++i) {
      soup.X.col(3 * t + i) = mesh.X.col(mesh.elements(i, t));
      soup.elements(i, t) = 3 * t + i;
    }
  return soup;
}

Mesh with_triangles(Mesh mesh, const std::vector<Eigen::Vector3i>& more) {
  const auto old = mesh.elements.cols();
  mesh.elements.conservativeResize(3, old + static_cast<Eigen::Index>(more.size()));
  for (std::size_t i = 0; i < more.size(); ++i) mesh.elements.col(old + static_cast<Eigen::Index>(i)) = more[i];
  return mesh;
}

// Every vertex displaced by up to `by`: faces pass through each other.
Mesh shaken(Mesh mesh, double by) {
  for (Eigen::Index i = 0; i < mesh.X.size(); ++i) mesh.X.reshaped()[i] += by * std::sin(37.0 * static_cast<double>(i));
  return mesh;
}

Mesh cut_off_below(const Mesh& mesh, double z) {
  std::vector<int> kept;
  for (int t = 0; t < mesh.element_count(); ++t)
    if (mesh.X(2, mesh.elements.col(t)).maxCoeff() > z) kept.push_back(t);
  Mesh cut = mesh;
  cut.elements = mesh.elements(Eigen::indexing::all, kept);
  return cut;
}

Mesh with_dust(Mesh mesh) {
  for (int i = 0; i < 12; ++i) mesh = joined(mesh, ball(0.17, 1.25 * Vec3(std::cos(i), std::sin(i), 0), 1));
  return mesh;
}

// The sides of its one face match no vertices of the others: cracks without width.
Mesh with_cracks() {
  const Mesh block = block_surface({2, 1, 1});
  std::vector<int> kept;
  for (int t = 0; t < block.element_count(); ++t)
    if (block.X(2, block.elements.col(t)).minCoeff() < 1) kept.push_back(t);
  Mesh open = block;
  open.elements = block.elements(Eigen::indexing::all, kept);
  Eigen::Matrix3Xd lid(3, 4);
  lid << 0, 2, 2, 0, 0, 0, 1, 1, 1, 1, 1, 1;
  Eigen::Matrix3Xi two(3, 2);
  two << 0, 0, 1, 2, 2, 3;
  return joined(open, surface_of(lid, two));
}

Mesh moebius_strip() {
  constexpr int n = 40;
  Eigen::Matrix3Xd X(3, 2 * n);
  Eigen::Matrix3Xi triangles(3, 2 * n);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    for (int side : {0, 1}) {
      const double r = 1 + (side == 0 ? -0.3 : 0.3) * std::cos(a / 2);
      X.col(2 * i + side) = Vec3(r * std::cos(a), r * std::sin(a), (side == 0 ? -0.3 : 0.3) * std::sin(a / 2));
    }
    const bool last = i == n - 1;
    const int a0 = 2 * i, a1 = 2 * i + 1, b0 = last ? 1 : 2 * i + 2, b1 = last ? 0 : 2 * i + 3;
    triangles.col(2 * i) << a0, b0, a1;
    triangles.col(2 * i + 1) << a1, b0, b1;
  }
  return surface_of(X, triangles);
}

Mesh wall_at(double x) {
  Eigen::Matrix3Xd X(3, 4);
  X << x, x, x, x, 0, 1, 1, 0, 0, 0, 1, 1;
  Eigen::Matrix3Xi two(3, 2);
  two << 0, 0, 1, 2, 2, 3;
  return surface_of(X, two);
}

std::vector<DirtySurface> dirty_surfaces() {
  const auto open = [](const Filling& f) { return f.shells.open_edges; };
  const auto crowded = [](const Filling& f) { return f.shells.crowded_edges; };
  const auto turned = [](const Filling& f) { return f.shells.turned; };
  const auto inside_out = [](const Filling& f) { return f.shells.inside_out; };
  const auto shells = [](const Filling& f) { return f.shells.count; };
  const auto cavities = [](const Filling& f) { return f.shells.cavities; };
  const Mesh ball_1 = ball(1), ball_half = ball(0.5);
  const int all = ball_1.element_count(), half = ball_half.element_count();
  // Two that overlap have 2 V minus the lens of height 0.5 on each side, pi h^2 (3 - h)/3.
  const double two_balls = 2 * whole_ball - 2 * std::numbers::pi * 0.25 * 2.5 / 3;
  const char* nothing = "mesh.surface: encloses nothing";
  return {
      {"a hole of twelve triangles", without_triangles(ball_1, 100, 12), 0.2, whole_ball, 0.05, "", open, 10},
      {"faces that are turned", turned_over(ball_1, 40, 200), 0.2, whole_ball, 0.05, "", turned, 200},
      {"a shell that is inside out", turned_over(ball_1, 0, all), 0.2, whole_ball, 0.05, "", inside_out, 1},
      {"shells that cross", joined(ball_1, ball(1, {1, 0, 0})), 0.2, two_balls, 0.05, "", shells, 2},
      {"a cavity", joined(ball_1, turned_over(ball_half, 0, half)), 0.15, whole_ball * 7 / 8, 0.06, "", cavities, 1},
      {"a shell inside of another, not turned", joined(ball_1, ball_half), 0.2, whole_ball, 0.05, "", shells, 2},
      {"every face twice", joined(ball_1, ball_1), 0.2, whole_ball, 0.05, "", shells, 2},
      {"a face twice, on the same vertices", with_triangles(ball_1, {ball_1.elements.col(0), ball_1.elements.col(1)}),
       0.2, whole_ball, 0.05, "", crowded, 6},
      {"faces without area", with_triangles(ball_1, {{0, 0, 1}, {2, 2, 2}, {5, 7, 5}}), 0.2, whole_ball, 0.05, ""},
      {"half of a ball, open below", cut_off_below(ball_1, 0), 0.15, whole_ball / 2, 0.1, ""},
      {"kilometres", scaled(ball_1, 1e6), 0.2e6, 1e18 * whole_ball, 0.05, ""},
      {"micrometres", scaled(ball_1, 1e-6), 0.2e-6, 1e-18 * whole_ball, 0.05, ""},
      {"far from the origin", moved(ball_1, {4e5, -2e6, 1e6}), 0.2, whole_ball, 0.05, ""},
      {"two blocks that share an edge", joined(block_surface({1, 1, 1}), block_surface({1, 1, 1}, {1, 1, 0})), 0.15, 2,
       0.05, ""},
      {"two balls that touch", joined(ball_1, ball(1, {2, 0, 0})), 0.2, 2 * whole_ball, 0.05, ""},
      {"dust", with_dust(ball_1), 0.2, whole_ball, 0.05, "", shells, 13},
      {"vertices that are shaken", shaken(ball_1, 0.04), 0.2, whole_ball, 0.08, ""},
      {"cracks where vertices do not match", with_cracks(), 0.1, 2, 0.04, "", open, 20},
      {"a soup of triangles", soup_of(ball_1), 0.2, whole_ball, 0.05, "", open, 3 * all},
      {"a wall inside", joined(block_surface({2, 1, 1}), wall_at(1)), 0.1, 2, 0.04, ""},
      {"a plate that is thinner than an edge", block_surface({2, 1, 0.004}), 0.2, 0, 0,
       "mesh.surface: encloses nothing as large as mesh.size"},
      {"a flat sheet", generate_sheet({2, 1}, {8, 4}, {1, 1}, ElementKind::tri3), 0.1, 0, 0, nothing},
      {"every face turned both ways", joined(ball_1, turned_over(ball_1, 0, all)), 0.2, whole_ball, 0.05, ""},
  };
}

// The reason, where it is refused.
std::string outcome(const DirtySurface& dirty, Filling& filling) {
  try {
    filling = fill(dirty.surface, dirty.size);
  } catch (const InputError& error) {
    return error.key + ": " + error.what();
  }
  return "";
}

TEST(FillDirty, SurfacesBecomeBodiesOrAreRefusedWithTheirReason) {
  int bodies = 0, refused = 0;
  for (const DirtySurface& dirty : dirty_surfaces()) {
    SCOPED_TRACE(dirty.name);
    Filling filling;
    const std::string reason = outcome(dirty, filling);
    if (dirty.volume == 0) {
      EXPECT_EQ(reason.find(dirty.reason), 0) << reason;
      ++refused;
      continue;
    }
    ++bodies;
    ASSERT_EQ(reason, "");
    const double volume = total_measure(filling.mesh);
    EXPECT_NEAR(volume / dirty.volume, 1, dirty.share);
    EXPECT_NEAR(enclosed_measure(filling.mesh) / volume, 1, 1e-8);  // no face inside is left open
    EXPECT_GT(filling.smallest_angle, 9);
    EXPECT_GT(filling.spanned, 0.7);
    if (dirty.count) {
      EXPECT_EQ(dirty.count(filling), dirty.counted);
    }
  }
  EXPECT_GE(bodies, 20);
  EXPECT_EQ(refused, 2);
}

// Here and there a strip of one side winds round more than half: a few tets, and the body says so.
TEST(FillDirty, AStripOfOneSideIsHardlyABody) {
  const Filling filling = fill(moebius_strip(), 0.1);
  EXPECT_LT(total_measure(filling.mesh), 1e-3);
  EXPECT_LT(filling.spanned, 0.5);
}

}  // namespace
}  // namespace sim::test
