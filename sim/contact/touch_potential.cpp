#include "sim/contact/touch_potential.h"

#include "sim/contact/mollifier.h"
#include "sim/contact/pair_tangent.h"

namespace sim {

namespace {

// Numbers of the nearest points' own order, put where the touch has these points.
PairVector spread(const Touch& touch, const PairVector& g) {
  if (touch.e == 0) return g;
  PairVector all = PairVector::Zero();
  for (int i = 0; i < node_count(touch.feature); ++i) all.segment<3>(3 * touch.near[i]) = g.segment<3>(3 * i);
  return all;
}
PairMatrix spread(const Touch& touch, const PairMatrix& H) {
  PairMatrix all = PairMatrix::Zero();
  for (int i = 0; i < node_count(touch.feature); ++i)
    for (int j = 0; j < node_count(touch.feature); ++j)
      all.block<3, 3>(3 * touch.near[i], 3 * touch.near[j]) = H.block<3, 3>(3 * i, 3 * j);
  return all;
}

Distance distance_of(const Touch& touch, const Eigen::Matrix3Xd& positions, Vec3* x, Vec3* near) {
  for (int i = 0; i < points_in(touch); ++i) x[i] = positions.col(touch.point[i]);
  for (int i = 0; i < node_count(touch.feature); ++i) near[i] = x[touch.near[i]];
  return Distance(touch.feature, near);
}

}  // namespace

double touch_energy(const Touch& touch, const Couple& couple, const Eigen::Matrix3Xd& x) {
  const double U = touch.weight * Barrier(touch.d - couple.xi, couple.dh).b;
  if (touch.e == 0) return U;
  Vec3 ends[4];
  for (int i = 0; i < 4; ++i) ends[i] = x.col(touch.point[i]);
  return U * mollifier(ends, touch.e);
}

TouchPotential::TouchPotential(const Touch& it, const Couple& couple, const Eigen::Matrix3Xd& positions)
    : touch(it), distance(distance_of(it, positions, x, near)), b(distance.d - couple.xi, couple.dh) {
  if (touch.e > 0) M = mollifier(x, touch.e);
}

// weight (b grad M + M b' grad d)
PairVector TouchPotential::gradient() const {
  const PairVector g = spread(touch, distance.gradient());
  if (touch.e == 0) return touch.weight * b.first * g;
  return touch.weight * (b.b * MollifierTangent(x, touch.e).gradient + M * b.first * g);
}

// weight [b Hess M + b' (grad M grad d^T + grad d grad M^T) + M Hess b]
PairMatrix TouchPotential::tangent(Definiteness fix) const {
  if (touch.e == 0) return touch.weight * pair_tangent(distance, b.first, b.second, fix);
  const MollifierTangent own(x, touch.e);
  const PairVector g = spread(touch, distance.gradient());
  const PairMatrix cross = b.first * own.gradient * g.transpose();
  const PairMatrix H = b.b * own.hessian + cross + cross.transpose() +
                       M * spread(touch, pair_tangent(distance, b.first, b.second, Definiteness::none));
  return touch.weight * (fix == Definiteness::none ? H : without_negative_part(H));
}

}  // namespace sim
