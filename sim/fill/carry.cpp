#include "sim/fill/carry.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/math/vec3.h"

namespace sim {
namespace {

// Elements by the cells of a regular grid that their boxes meet.
class Grid {
 public:
  explicit Grid(const Mesh& mesh) : mesh_(mesh) {
    low_ = mesh.X.rowwise().minCoeff();
    const Vec3 extent = mesh.X.rowwise().maxCoeff() - low_;
    const double cells = std::cbrt(static_cast<double>(mesh.element_count()));
    cell_ = std::max(extent.maxCoeff() / std::max(cells, 1.0), 1e-300);
    for (int axis = 0; axis < 3; ++axis) n_[axis] = static_cast<int>(extent[axis] / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2]);
    for (int e = 0; e < mesh.element_count(); ++e) {
      Eigen::AlignedBox3d box;
      for (int i = 0; i < 4; ++i) box.extend(Vec3(mesh.X.col(mesh.elements(i, e))));
      visit(cell_at(box.min()), cell_at(box.max()), [&](std::size_t k) { cells_[k].push_back(e); });
    }
  }

  int rings() const { return std::max({n_[0], n_[1], n_[2]}); }

  // Calls f(element) for those in the cells at most `ring` from the point's; an element may come more than once.
  template <class F>
  void visit_near(const Vec3& x, int ring, const F& f) const {
    std::array<int, 3> from = cell_at(x), to = from;
    for (int axis = 0; axis < 3; ++axis) {
      from[axis] = std::max(from[axis] - ring, 0);
      to[axis] = std::min(to[axis] + ring, n_[axis] - 1);
    }
    visit(from, to, [&](std::size_t k) {
      for (const int e : cells_[k]) f(e);
    });
  }

 private:
  std::array<int, 3> cell_at(const Vec3& x) const {
    std::array<int, 3> cell{};
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<int>(std::clamp((x[axis] - low_[axis]) / cell_, 0.0, n_[axis] - 1.0));
    return cell;
  }
  template <class F>
  void visit(const std::array<int, 3>& from, const std::array<int, 3>& to, const F& f) const {
    for (int z = from[2]; z <= to[2]; ++z)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int x = from[0]; x <= to[0]; ++x)
          f(static_cast<std::size_t>(x) + static_cast<std::size_t>(n_[0]) * (y + static_cast<std::size_t>(n_[1]) * z));
  }

  const Mesh& mesh_;
  Vec3 low_ = {0, 0, 0};
  double cell_ = 1;  // m
  std::array<int, 3> n_{};
  std::vector<std::vector<int>> cells_;
};

Eigen::Vector4d barycentric(const Mesh& mesh, int element, const Vec3& x) {
  Eigen::Matrix3d edges;
  const Vec3 origin = mesh.X.col(mesh.elements(0, element));
  for (int i = 0; i < 3; ++i) edges.col(i) = mesh.X.col(mesh.elements(i + 1, element)) - origin;
  const Vec3 b = edges.inverse() * (x - origin);
  return {1 - b.sum(), b[0], b[1], b[2]};
}

MaterialPoint best_near(const Mesh& mesh, const Grid& grid, const Vec3& x) {
  MaterialPoint best;
  double inside = -std::numeric_limits<double>::infinity();
  // A ring after the first one in which there is an element: a nearer one may be there.
  for (int ring = 0, last = grid.rings(); ring <= last && inside < 0; ++ring) {
    if (inside > -std::numeric_limits<double>::infinity()) last = ring;
    grid.visit_near(x, ring, [&](int e) {
      const Eigen::Vector4d weights = barycentric(mesh, e, x);
      if (!(weights.minCoeff() > inside)) return;
      inside = weights.minCoeff();
      best = {e, {weights[0], weights[1], weights[2], weights[3]}};
    });
  }
  return best;
}

}  // namespace

std::vector<MaterialPoint> carry(const Mesh& mesh, const Eigen::Matrix3Xd& points) {
  const Grid grid(mesh);
  std::vector<MaterialPoint> carried;
  carried.reserve(static_cast<std::size_t>(points.cols()));
  for (const auto& x : points.colwise()) carried.push_back(best_near(mesh, grid, x));
  return carried;
}

double farthest_outside(const std::vector<MaterialPoint>& points) {
  double farthest = 0;
  for (const MaterialPoint& point : points)
    farthest = std::max(farthest, -*std::min_element(point.weights.begin(), point.weights.end()));
  return farthest;
}

}  // namespace sim
