#include <algorithm>
#include <cmath>

#include "sim/residual/basis.h"

namespace sim::residual {

void sample_hats(Real x, std::span<Sample> all) {
  std::ranges::fill(all, Sample{});
  const int n = static_cast<int>(all.size()), cells = n + 1;
  const int cell = std::clamp(static_cast<int>(std::floor(x * cells)), 0, n);
  const Real share = x * cells - cell;  // of the way through the cell
  if (cell > 0) all[cell - 1] = {1 - share, Real(-cells), 0};
  if (cell < n) all[cell] = {share, Real(cells), 0};
}

}  // namespace sim::residual
