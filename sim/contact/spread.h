// What acts between two closest points, or on the nodes that carry a distance, as three numbers for each of up to four
// nodes of a pair.
#pragma once

#include <span>

#include "sim/contact/distance.h"

namespace sim {

// C^T k, for a vector k at the closest points; c: the nodes' shares of them.
inline PairVector spread(std::span<const double> c, const Vec3& k) {
  PairVector all = PairVector::Zero();
  for (std::size_t i = 0; i < c.size(); ++i) all.segment<3>(3 * static_cast<Eigen::Index>(i)) = c[i] * k;
  return all;
}
// C^T K C
inline PairMatrix spread(std::span<const double> c, const Eigen::Matrix3d& K) {
  PairMatrix all = PairMatrix::Zero();
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < c.size(); ++j)
      all.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(j)) = c[i] * c[j] * K;
  return all;
}

// Numbers of the nodes that carry a distance, put where the pair has these: node[i] is the place of the i-th of
// `count`.
inline PairVector put(const std::array<int, 4>& node, int count, const PairVector& g) {
  PairVector all = PairVector::Zero();
  for (int i = 0; i < count; ++i) all.segment<3>(3 * node[i]) = g.segment<3>(3 * i);
  return all;
}
inline PairMatrix put(const std::array<int, 4>& node, int count, const PairMatrix& H) {
  PairMatrix all = PairMatrix::Zero();
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) all.block<3, 3>(3 * node[i], 3 * node[j]) = H.block<3, 3>(3 * i, 3 * j);
  return all;
}

}  // namespace sim
