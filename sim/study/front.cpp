#include "sim/study/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sim {

std::vector<int> front(std::span<const WorkError> points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return points[a].work != points[b].work ? points[a].work < points[b].work : points[a].error < points[b].error;
  });
  std::vector<int> members;
  double best = std::numeric_limits<double>::infinity();
  for (const int k : order) {
    if (!(points[k].error < best)) continue;
    best = points[k].error;
    members.push_back(k);
  }
  return members;
}

int knee(std::span<const WorkError> points, std::span<const int> members) {
  const WorkError &first = points[members.front()], &last = points[members.back()];
  const double width = std::log(last.work / first.work), height = std::log(first.error / last.error);
  int best = members.front();
  double farthest = 0;
  for (const int k : members) {
    // From (0, 1) to (1, 0): below the line where u + w < 1.
    const double u = width > 0 ? std::log(points[k].work / first.work) / width : 0,
                 w = height > 0 ? std::log(points[k].error / last.error) / height : 0;
    if (1 - u - w > farthest) {
      farthest = 1 - u - w;
      best = k;
    }
  }
  return best;
}

}  // namespace sim
