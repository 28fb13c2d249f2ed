// Families of functions u_1 ... u_n on [0,1] that are zero at both ends.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "sim/residual/real.h"

namespace sim::residual {

// u(x), u'(x), u''(x)
struct Sample {
  Real value = 0, slope = 0, curvature = 0;
};

struct Basis {
  std::string_view name;
  bool smooth;  // has a second derivative everywhere
  // All u_i at x, i = 1 ... all.size().
  void (*sample)(Real x, std::span<Sample> all);
};

// A new basis is a file and a line there.
std::span<const Basis> bases();
// nullptr when the name is not one of a basis.
const Basis* find_basis(std::string_view name);

// sin(i pi x)
void sample_sines(Real x, std::span<Sample> all);
// Integrated Legendre polynomials (P_{i+1}(t) - P_{i-1}(t))/(2 (2i + 1)), t = 2x - 1.
void sample_polynomials(Real x, std::span<Sample> all);
// 1 at the node i h, 0 at all others, h = 1/(n + 1), linear between them. At a node the slope is that to its right.
void sample_hats(Real x, std::span<Sample> all);

// The sum of integrated Legendre polynomials with coefficients c, as coefficients of x^i (1 - x). They grow like
// 6^n with alternating signs: above some 12 terms nothing of their digits is right.
Vector to_monomials(const Vector& c);

// u = sum c_i u_i in a basis.
class Trial {
 public:
  Trial(const Basis& basis, Vector c) : basis_(basis), c_(std::move(c)) {}

  const Basis& basis() const { return basis_; }
  const Vector& coefficients() const { return c_; }
  Sample at(Real x) const;

 private:
  Basis basis_;
  Vector c_;
};

}  // namespace sim::residual
