#include "sim/contact/touch_potential.h"

#include "sim/contact/mollifier.h"
#include "sim/contact/pair_tangent.h"
#include "sim/contact/spread.h"

namespace sim {

namespace {

// Where the touch has the points that carry the distance.
template <class Numbers>
Numbers at_points(const Touch& touch, const Numbers& own) {
  return put(touch.near, node_count(touch.feature), own);
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
  if (touch.e == 0) return touch.weight * b.first * distance.gradient();
  const PairVector g = at_points(touch, distance.gradient());
  return touch.weight * (b.b * MollifierTangent(x, touch.e).gradient + M * b.first * g);
}

// weight [b Hess M + b' (grad M grad d^T + grad d grad M^T) + M Hess b]
PairMatrix TouchPotential::tangent(Definiteness fix) const {
  if (touch.e == 0) return touch.weight * pair_tangent(distance, b.first, b.second, fix);
  const MollifierTangent own(x, touch.e);
  const PairVector g = at_points(touch, distance.gradient());
  const PairMatrix cross = b.first * own.gradient * g.transpose();
  const PairMatrix H = b.b * own.hessian + cross + cross.transpose() +
                       M * at_points(touch, pair_tangent(distance, b.first, b.second, Definiteness::none));
  return touch.weight * (fix == Definiteness::none ? H : without_negative_part(H));
}

}  // namespace sim
