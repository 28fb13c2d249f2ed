#include "sim/mesh/spoil.h"

#include <algorithm>

#include "sim/element/element.h"
#include "sim/mesh/check.h"
#include "sim/mesh/input_error.h"

namespace sim {

namespace {

// Middle nodes half-way between their corners again.
void straighten(Mesh& mesh) {
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const auto& [a, b, middle] : info(mesh.kind).edges)
      if (middle >= 0)
        mesh.X.col(mesh.elements(middle, e)) = (mesh.X.col(mesh.elements(a, e)) + mesh.X.col(mesh.elements(b, e))) / 2;
}

bool is_sound(Mesh mesh) {
  try {
    return check_and_orient(mesh).reoriented == 0;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

void lengthen(Mesh& mesh, double ratio) {
  Eigen::Index axis = 0;
  (mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff()).maxCoeff(&axis);
  mesh.X.row(axis) *= ratio;
}

void make_slivers(Mesh& mesh, double left) {
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const auto& [a, b, middle] : info(mesh.kind).edges) {
      Mesh tried = mesh;
      const int i = mesh.elements(a, e), j = mesh.elements(b, e);
      tried.X.col(i) = (1 - left) * mesh.X.col(j) + left * mesh.X.col(i);
      straighten(tried);
      if (!is_sound(tried)) continue;
      mesh = tried;
      return;
    }
}

void disconnect(Mesh& mesh, int count) {
  const int n = static_cast<int>(mesh.elements.rows());
  count = std::min(count, mesh.element_count());
  Mesh parts;
  parts.kind = mesh.kind;
  parts.X.resize(mesh.X.rows(), static_cast<Eigen::Index>(n) * count);
  parts.elements.resize(n, count);
  for (int e = 0; e < count; ++e)
    for (int a = 0; a < n; ++a) {
      parts.elements(a, e) = n * e + a;
      parts.X.col(n * e + a) = mesh.X.col(mesh.elements(a, e));
    }
  mesh = std::move(parts);
}

}  // namespace sim
