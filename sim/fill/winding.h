// How often a surface winds round a point: 1 inside, 0 outside, and in between where the surface has holes.
// [Jacobson, Kavan & Sorkine-Hornung 2013; far triangles together: Barill et al. 2018]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/math/vec3.h"

namespace sim {

class Winding {
 public:
  // Both must outlive it.
  Winding(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xi& triangles);

  // w(x) = sum of the solid angles of the triangles over 4 pi.
  double at(const Vec3& x) const;

 private:
  // A box of triangles; beyond three times its radius it is a dipole: solid angle A.(c - x)/|c - x|^3.
  struct Branch {
    Vec3 centre, area;  // mean of the triangles' middles, weighted by area; sum of the area vectors
    double radius = 0;  // of a ball round `centre` that holds all
    int first = 0, last = 0, next = 0;
  };
  void grow(std::vector<Vec3>& middles, int first, int last);
  void measure(Branch& branch) const;
  double solid_angle(int triangle, const Vec3& x) const;

  const Eigen::Matrix3Xd& X_;
  const Eigen::Matrix3Xi& triangles_;
  std::vector<int> items_;
  std::vector<Branch> branches_;  // depth first; `next` is what comes after all children
};

}  // namespace sim
