#include "sim/residual/basis.h"

#include <algorithm>

namespace sim::residual {

std::span<const Basis> bases() {
  static constexpr Basis table[] = {
      {"sines", true, sample_sines},
      {"polynomials", true, sample_polynomials},
      {"hats", false, sample_hats},
  };
  return table;
}

const Basis* find_basis(std::string_view name) {
  const auto found = std::ranges::find(bases(), name, &Basis::name);
  return found == bases().end() ? nullptr : &*found;
}

Sample Trial::at(Real x) const {
  std::vector<Sample> all(c_.size());
  basis_.sample(x, all);
  Sample u;
  for (Eigen::Index i = 0; i < c_.size(); ++i) {
    u.value += c_[i] * all[i].value;
    u.slope += c_[i] * all[i].slope;
    u.curvature += c_[i] * all[i].curvature;
  }
  return u;
}

}  // namespace sim::residual
