#include "sim/fill/winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace sim {

Winding::Winding(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xi& triangles) : X_(X), triangles_(triangles) {
  items_.resize(static_cast<std::size_t>(triangles.cols()));
  std::iota(items_.begin(), items_.end(), 0);
  std::vector<Vec3> middles;
  for (const auto& t : triangles.colwise()) middles.push_back((X.col(t[0]) + X.col(t[1]) + X.col(t[2])) / 3);
  if (!items_.empty()) grow(middles, 0, static_cast<int>(items_.size()));
}

// Halves at the median of the longest side.
void Winding::grow(std::vector<Vec3>& middles, int first, int last) {
  constexpr int few = 8;
  const std::size_t k = branches_.size();
  branches_.push_back({{}, {}, 0, first, last, 0});
  measure(branches_[k]);
  if (last - first > few) {
    Vec3 low = middles[items_[first]], high = low;
    for (int i = first; i < last; ++i) {
      low = low.cwiseMin(middles[items_[i]]);
      high = high.cwiseMax(middles[items_[i]]);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const int half = (first + last) / 2;
    std::nth_element(items_.begin() + first, items_.begin() + half, items_.begin() + last, [&](int a, int b) {
      return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis] : a < b;
    });
    branches_[k].last = first;  // what children have, it has not
    grow(middles, first, half);
    grow(middles, half, last);
  }
  branches_[k].next = static_cast<int>(branches_.size());
}

void Winding::measure(Branch& branch) const {
  branch.centre.setZero();
  branch.area.setZero();
  double total = 0;
  for (int i = branch.first; i < branch.last; ++i) {
    const auto t = triangles_.col(items_[i]);
    const Vec3 a = X_.col(t[0]), b = X_.col(t[1]), c = X_.col(t[2]), area = (b - a).cross(c - a) / 2;
    branch.area += area;
    branch.centre += area.norm() * (a + b + c) / 3;
    total += area.norm();
  }
  if (total > 0) branch.centre /= total;
  for (int i = branch.first; i < branch.last; ++i)
    for (int v = 0; v < 3; ++v)
      branch.radius = std::max(branch.radius, (X_.col(triangles_(v, items_[i])) - branch.centre).norm());
}

// [Van Oosterom & Strackee 1983]
double Winding::solid_angle(int triangle, const Vec3& x) const {
  const Vec3 a = X_.col(triangles_(0, triangle)) - x, b = X_.col(triangles_(1, triangle)) - x,
             c = X_.col(triangles_(2, triangle)) - x;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(a.dot(b.cross(c)), below);
}

double Winding::at(const Vec3& x) const {
  constexpr double far = 3;
  double angle = 0;
  for (std::size_t k = 0; k < branches_.size();) {
    const Branch& branch = branches_[k];
    const Vec3 way = branch.centre - x;
    const double distance = way.norm();
    if (distance > far * branch.radius) {
      angle += branch.area.dot(way) / (distance * distance * distance);
      k = static_cast<std::size_t>(branch.next);
      continue;
    }
    for (int i = branch.first; i < branch.last; ++i) angle += solid_angle(items_[i], x);
    ++k;
  }
  return angle / (4 * std::numbers::pi);
}

}  // namespace sim
