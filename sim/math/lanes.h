// The scalar of the inner loops: a batch of lanes, one element a lane. Every function here also exists for double,
// so that a kernel written once serves both.
#pragma once

#include <cmath>
#include <cstring>
#include <experimental/simd>
#include <utility>

// Before a function: every call in it is inlined, as lanes that pass through memory take half as long again. Not where
// memory is checked: the code would grow beyond what compiles in minutes.
#ifdef __SANITIZE_ADDRESS__
#define SIM_FLATTEN
#else
#define SIM_FLATTEN [[gnu::flatten]]
#endif

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

// to += from, n numbers
template <int n>
void add(const double* from, double* to) {
  constexpr std::experimental::element_aligned_tag anywhere;
  constexpr int whole = n / lane_count * lane_count;
  for (int i = 0; i < whole; i += lane_count)
    (Lanes(to + i, anywhere) + Lanes(from + i, anywhere)).copy_to(to + i, anywhere);
  for (int i = whole; i < n; ++i) to[i] += from[i];
}

// Transposes a square of lanes in place: rows[i][k] <-> rows[k][i]. Each round interleaves row i with row i + n/2,
// which turns the 2 log2 n bits of an entry's address (row, lane) by one; after log2 n rounds row and lane have changed
// places.
inline void transpose(Lanes (&rows)[lane_count]) {
  typedef double Row __attribute__((vector_size(sizeof(Lanes))));
  constexpr int n = lane_count;
  Row from[n], to[n];
  std::memcpy(from, rows, sizeof from);
  const auto interleave = [&]<int... k>(std::integer_sequence<int, k...>) {
    for (int i = 0; i < n / 2; ++i) {
      to[2 * i] = __builtin_shufflevector(from[i], from[i + n / 2], (k / 2 + k % 2 * n)...);
      to[2 * i + 1] = __builtin_shufflevector(from[i], from[i + n / 2], (n / 2 + k / 2 + k % 2 * n)...);
    }
  };
  for (int round = 1; round < n; round *= 2) {
    interleave(std::make_integer_sequence<int, n>());
    std::memcpy(from, to, sizeof from);
  }
  std::memcpy(rows, from, sizeof from);
}

}  // namespace sim
