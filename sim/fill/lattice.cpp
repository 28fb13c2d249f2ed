#include "sim/fill/lattice.h"

#include <cmath>

namespace sim {

Lattice Lattice::around(const Vec3& low, const Vec3& high, double a) {
  Lattice lattice;
  lattice.a = a;
  for (int axis = 0; axis < 3; ++axis) {
    lattice.n[axis] = static_cast<int>(std::ceil((high[axis] - low[axis]) / a)) + 2;
    lattice.origin[axis] = (low[axis] + high[axis] - a * lattice.n[axis]) / 2;
  }
  return lattice;
}

int Lattice::number(const Eigen::Vector3i& c) const {
  const bool odd = (c[0] & 1) != 0;
  const int x = c[0] / 2, y = c[1] / 2, z = c[2] / 2;
  if (odd) return even_count() + x + n[0] * (y + n[1] * z);
  return x + (n[0] + 1) * (y + (n[1] + 1) * z);
}

Eigen::Vector3i Lattice::coordinates(int vertex) const {
  const int odd = vertex < even_count() ? 0 : 1;
  const int k = odd != 0 ? vertex - even_count() : vertex;
  const int nx = n[0] + 1 - odd, ny = n[1] + 1 - odd;
  return {2 * (k % nx) + odd, 2 * (k / nx % ny) + odd, 2 * (k / nx / ny) + odd};
}

}  // namespace sim
