// Takes the force between two edges away as they become parallel, where their closest points jump: [Li et al. 2020]
//   y = |u x v|^2, e = 1e-3 |U|^2 |V|^2 (edges at rest), z = y/e:  M = z (2 - z) for z < 1, else 1
//   M' = 2 (1 - z)/e,  M'' = -2/e^2,  dy/du = 2 (|v|^2 u - (u.v) v), dy/dv alike,
//   Huu = 2 (|v|^2 I - v v^T),  Huv = 2 (2 u v^T - (u.v) I - v u^T)
#pragma once

#include "sim/contact/distance.h"

namespace sim {

// e of two edges with these squared lengths at rest [m^4]
constexpr double mollifier_start(double U2, double V2) {
  return 1e-3 * U2 * V2;
}

// M alone, of the edges from x[0] to x[1] and from x[2] to x[3].
double mollifier(const Vec3* x, double e);

struct MollifierTangent {
  MollifierTangent(const Vec3* x, double e);
  double M;
  PairVector gradient;
  PairMatrix hessian;
};

}  // namespace sim
