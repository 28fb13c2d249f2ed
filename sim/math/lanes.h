// The scalar of the inner loops: a batch of lanes, one element a lane. Every function here also exists for double,
// so that a kernel written once serves both.
#pragma once

#include <cmath>
#include <experimental/simd>

namespace sim {

using Lanes = std::experimental::native_simd<double>;
inline constexpr int lane_count = static_cast<int>(Lanes::size());

inline double select(bool mask, double yes, double no) {
  return mask ? yes : no;
}
inline Lanes select(const Lanes::mask_type& mask, const Lanes& yes, Lanes no) {
  where(mask, no) = yes;
  return no;
}

inline bool all(bool mask) {
  return mask;
}
inline bool all(const Lanes::mask_type& mask) {
  return all_of(mask);
}

inline double square_root(double a) {
  return std::sqrt(a);
}
inline Lanes square_root(const Lanes& a) {
  return std::experimental::sqrt(a);
}

inline double absolute(double a) {
  return std::abs(a);
}
inline Lanes absolute(const Lanes& a) {
  return std::experimental::abs(a);
}

inline double natural_log(double a) {
  return std::log(a);
}
inline Lanes natural_log(const Lanes& a) {
  return Lanes([&](auto k) { return std::log(static_cast<double>(a[k])); });
}

template <class T>
T maximum(const T& a, const T& b) {
  return select(a < b, b, a);
}

// |a| with the sign of b; b = 0 counts as positive.
template <class T>
T with_sign(const T& a, const T& b) {
  return select(b < T(0), -absolute(a), absolute(a));
}

}  // namespace sim
