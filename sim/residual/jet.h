// Arithmetic of values with their derivatives: every function of jets is the function and the chain rule.
#pragma once

#include <cmath>
#include <numbers>

#include "sim/residual/real.h"

namespace sim::residual {

// g(a) with g'(a); where a does not vary, neither does g(a), though g' may be infinite there.
inline Jet chain(Jet a, Real value, Real derivative) {
  return {value, a.slope == 0 ? 0 : derivative * a.slope};
}

inline Jet operator-(Jet a) {
  return {-a.value, -a.slope};
}
inline Jet operator+(Jet a, Jet b) {
  return {a.value + b.value, a.slope + b.slope};
}
inline Jet operator-(Jet a, Jet b) {
  return {a.value - b.value, a.slope - b.slope};
}
inline Jet operator*(Jet a, Jet b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
inline Jet operator/(Jet a, Jet b) {
  const Real quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}

inline Jet sin(Jet a) {
  return chain(a, std::sin(a.value), std::cos(a.value));
}
inline Jet cos(Jet a) {
  return chain(a, std::cos(a.value), -std::sin(a.value));
}
inline Jet tan(Jet a) {
  const Real t = std::tan(a.value);
  return chain(a, t, 1 + t * t);
}
inline Jet exp(Jet a) {
  const Real e = std::exp(a.value);
  return chain(a, e, e);
}
inline Jet log(Jet a) {
  return chain(a, std::log(a.value), 1 / a.value);
}
inline Jet log10(Jet a) {
  return chain(a, std::log10(a.value), 1 / (a.value * std::numbers::ln10_v<Real>));
}
inline Jet sqrt(Jet a) {
  const Real root = std::sqrt(a.value);
  return chain(a, root, 1 / (2 * root));
}
inline Jet abs(Jet a) {
  return a.value < 0 ? -a : a;
}

// a^b: b a^(b-1) a' where b does not vary, and so for negative a with whole b; else (e^(b ln a))'.
inline Jet pow(Jet a, Jet b) {
  const Real value = std::pow(a.value, b.value);
  if (b.slope == 0) return chain(a, value, b.value == 0 ? 0 : b.value * std::pow(a.value, b.value - 1));
  return {value, value * (b.slope * std::log(a.value) + b.value * a.slope / a.value)};
}

}  // namespace sim::residual
