#include "sim/mesh/order.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "sim/element/element.h"
#include "sim/mesh/geometry.h"

namespace sim {
namespace {

// The low 21 bits of v, two zeros after each.
std::uint64_t spread(std::uint64_t v) {
  std::uint64_t spread = 0;
  for (int bit = 0; bit < 21; ++bit) spread |= (v >> bit & 1) << 3 * bit;
  return spread;
}

}  // namespace

// Morton code: the bits of the centroid's coordinates, scaled to 21-bit integers, interleaved [Morton 1966].
std::vector<int> spatial_order(const Mesh& mesh) {
  const int count = mesh.element_count(), corners = info(mesh.kind).corners;
  const Eigen::VectorXd low = mesh.X.rowwise().minCoeff();
  const double size = bounding_size(mesh.X), cells = (1 << 21) - 1;
  std::vector<std::uint64_t> code(count, 0);
  for (int e = 0; e < count; ++e) {
    Eigen::VectorXd centroid = Eigen::VectorXd::Zero(mesh.dimension());
    for (int i = 0; i < corners; ++i) centroid += mesh.X.col(mesh.elements(i, e)) / corners;
    for (int k = 0; k < mesh.dimension(); ++k) {
      const double scaled = std::clamp((centroid[k] - low[k]) / size * cells, 0.0, cells);
      code[e] |= spread(static_cast<std::uint64_t>(scaled)) << k;
    }
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return code[a] < code[b]; });
  return order;
}

}  // namespace sim
