#include "app/residuals/orders.h"

namespace app {
namespace {

using sim::residual::Real;

std::optional<Real> order_of(const Attempt& from, const Attempt& to, const std::optional<Real>& before,
                             const std::optional<Real>& after) {
  constexpr Real round_off = 1e-14L;
  if (!before || !after || *before < round_off || *after < round_off) return {};
  return sim::residual::order(from.u.basis(), from.n(), *before, to.n(), *after);
}

}  // namespace

std::vector<Orders> orders_of(const ResidualStudy& study) {
  std::vector<Orders> all;
  for (std::size_t i = 1; i < study.attempts.size(); ++i) {
    const Attempt &a = study.attempts[i - 1], &b = study.attempts[i];
    if (a.basis() != b.basis() || a.method != b.method) continue;
    const auto &before = a.errors, &after = b.errors;
    all.push_back({&a, &b, order_of(a, b, before.L2, after.L2), order_of(a, b, before.H1_seminorm, after.H1_seminorm),
                   order_of(a, b, before.residual_L2, after.residual_L2),
                   order_of(a, b, before.max_1001, after.max_1001)});
  }
  return all;
}

}  // namespace app
