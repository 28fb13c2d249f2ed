#include "sim/residual/method.h"

#include <algorithm>

namespace sim::residual {
namespace {

Answer collocate_equal(const Problem& problem, const Basis& basis, int n) {
  return collocate(problem, basis, equal_points(n));
}

Answer collocate_gauss(const Problem& problem, const Basis& basis, int n) {
  return collocate(problem, basis, gauss_points(n));
}

}  // namespace

std::span<const Method> methods() {
  static constexpr Method table[] = {
      {"collocation-equal", true, false, collocate_equal},
      {"collocation-gauss", true, false, collocate_gauss},
      {"least-squares", true, false, least_squares},
      {"galerkin", false, false, galerkin},
      {"ritz", false, true, ritz},
  };
  return table;
}

const Method* find_method(std::string_view name) {
  const auto found = std::ranges::find(methods(), name, &Method::name);
  return found == methods().end() ? nullptr : &*found;
}

std::string refusal(const Method& method, const Basis& basis) {
  if (basis.smooth || !method.needs_curvature) return {};
  return std::string(method.name) + " needs u'', and " + std::string(basis.name) +
         " have none: it is 0 inside the cells and without bound at the nodes";
}

}  // namespace sim::residual
