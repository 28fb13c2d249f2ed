#include "sim/study/reference_check.h"

#include <algorithm>
#include <cmath>

namespace sim {

ReferenceCheck check_reference(const ReferenceRuns& runs, const SamplePoints& points, double meaningless) {
  const Eigen::VectorXd moved = difference(runs.fine, runs.coarse, points).frames;
  ReferenceCheck check;
  while (check.frames < moved.size() && moved[check.frames] < meaningless) ++check.frames;
  check.diverges = check.frames < moved.size();
  check.horizon = check.frames > 0 ? runs.fine.t[check.frames - 1] : 0;
  const auto apart = [&](const Trajectory& a, const Trajectory& b) {
    return difference(a, b, points, check.frames).rms;
  };
  check.moved = apart(runs.fine, runs.coarse);
  check.apart = apart(runs.fine, runs.other);
  const double before = apart(runs.fine, runs.other_coarse);
  check.other_order = check.apart > 0 ? std::log2(before / check.apart) : 0;
  check.uncertainty = std::max(check.moved, check.apart);
  constexpr double round_off = 1e-9;
  check.agrees = check.frames > 0 && check.apart <= std::max(0.75 * before, 2 * check.moved) + round_off;
  return check;
}

}  // namespace sim
