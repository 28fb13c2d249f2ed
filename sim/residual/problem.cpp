#include "sim/residual/problem.h"

#include <cmath>
#include <sstream>

#include "sim/residual/grid.h"

namespace sim::residual {
namespace {

constexpr int cells = 1000;
constexpr Real too_large =
    1e100L;  // beyond it squares are no numbers of double any more, as tables and curves have them

std::string text_of(Real number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(6);
  text << number;
  return text.str();
}

std::string value_text(const std::string& key, Real x, Real value) {
  return key + "(" + text_of(x) + ") = " + text_of(value);
}

void check_finite(const std::string& key, const Function& function) {
  for (int i = 1; i < cells; ++i) {
    const Real x = Real(i) / cells, value = function(x).value;
    if (!(std::abs(value) < too_large))
      throw ProblemError(
          key, value_text(key, x, value) + ": must be a number below 1e100 in size for all x between 0 and 1");
  }
}

void check_positive(const Function& k) {
  for (int i = 0; i <= cells; ++i) {
    const Real x = Real(i) / cells, value = k(x).value;
    if (!(value > 0)) throw ProblemError("k", value_text("k", x, value) + ": must be > 0 for all x from 0 to 1");
  }
}

void check_ends(const Function& u) {
  Real largest = 0;
  for (int i = 0; i <= cells; ++i) largest = std::max(largest, std::abs(u(Real(i) / cells).value));
  for (const Real x : {Real(0), Real(1)}) {
    const Real value = u(x).value;
    if (!(std::abs(value) <= Real(1e-10) * largest))
      throw ProblemError("exact", value_text("exact", x, value) + ": must be 0 at x = 0 and x = 1");
  }
}

}  // namespace

Real apply(const Problem& problem, Real x, const Sample& u) {
  const Jet k = problem.k(x);
  return -k.value * u.curvature - k.slope * u.slope + problem.a(x).value * u.slope + problem.q(x).value * u.value;
}

void check(const Problem& problem) {
  check_finite("k", problem.k);
  check_positive(problem.k);
  check_finite("a", problem.a);
  check_finite("q", problem.q);
  check_finite("f", problem.f);
  if (!problem.exact) return;
  check_finite("exact", problem.exact);
  check_ends(problem.exact);
}

// With v = x^m u, u = x (1 - x): the terms of k and q cancel for every m, and those of a leave -m int a x^(m-1) u^2. As
// powers of x make up every function, an a that is not zero shows for some m.
Asymmetry asymmetry(const Problem& problem) {
  constexpr int most = 12;
  constexpr Real round_off = 1e-14L;
  const Grid grid = gauss_grid(problem, 1);
  for (int m = 1; m <= most; ++m) {
    Real difference = 0, size = 0;
    for (Eigen::Index p = 0; p < grid.x.size(); ++p) {
      const Real x = grid.x[p], power = std::pow(x, m);
      const Sample u = {x * (1 - x), 1 - 2 * x, -2}, v = {power * x * (1 - x), power * (m + 1 - (m + 2) * x),
                                                          power / x * ((m + 1) * m - Real(m + 2) * (m + 1) * x)};
      const Real one = v.value * apply(problem, x, u), other = u.value * apply(problem, x, v);
      difference += grid.weight[p] * (one - other);
      size += grid.weight[p] * (std::abs(one) + std::abs(other));
    }
    if (std::abs(difference) > round_off * size) return {m, difference};
  }
  return {};
}

}  // namespace sim::residual
