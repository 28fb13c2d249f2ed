#include "sim/mesh/locate.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <sstream>
#include <type_traits>

#include "sim/element/list.h"
#include "sim/mesh/boundary.h"
#include "sim/mesh/geometry.h"
#include "sim/mesh/input_error.h"

namespace sim {
namespace {

constexpr double tolerance = 1e-9;  // of the mesh size

// Into the reference element: a simplex has one corner more than dimensions, the others are [-1,1]^d.
template <class E>
std::array<double, E::dimension> clamped(std::array<double, E::dimension> xi) {
  if constexpr (E::corners == E::dimension + 1) {
    for (double& x : xi) x = std::max(x, 0.0);
    const double sum = std::accumulate(xi.begin(), xi.end(), 0.0);
    for (double& x : xi) x /= std::max(sum, 1.0);
  } else {
    for (double& x : xi) x = std::clamp(x, -1.0, 1.0);
  }
  return xi;
}

// Newton on X(xi) = X (Gauss-Newton on a surface in space): dX/dxi dxi = X - X(xi), from the centroid. Steps are cut to
// length 1, the size of the reference element. Convergence is quadratic: after a step below 1e-9 only rounding is left,
// and 30 steps are plenty where the point is inside.
template <class E, int D>
std::array<double, E::dimension> inverse_map(const Eigen::Matrix<double, D, E::nodes>& X_e, const Position<D>& X) {
  std::array<double, E::dimension> xi{};
  for (const auto& corner : E::corner_xi) {
    for (int k = 0; k < E::dimension; ++k) xi[k] += corner[k] / E::corners;
  }
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Position<D> r = X - position<E>(X_e, xi);
    const Jacobian<E, D> J = jacobian<E>(X_e, xi);
    Eigen::Matrix<double, E::dimension, 1> step;
    if constexpr (D == E::dimension)
      step = J.inverse() * r;
    else
      step = (J.transpose() * J).inverse() * (J.transpose() * r);
    const double length = step.norm(), cut = std::max(1.0, length);
    for (int k = 0; k < E::dimension; ++k) xi[k] += step[k] / cut;
    if (!(length >= 1e-9)) break;
  }
  return xi;
}

// Outside the element's box, widened by the tolerance and, for curved elements, by how far they may bulge out of it.
template <class E, int D>
bool outside_box(const Eigen::Matrix<double, D, E::nodes>& X_e, const Position<D>& X, double near) {
  Position<D> low, high;
  double longest = 0;
  for (int r = 0; r < D; ++r) {
    low[r] = high[r] = X_e(r, 0);
    for (int i = 1; i < E::nodes; ++i) {
      low[r] = std::min(low[r], X_e(r, i));
      high[r] = std::max(high[r], X_e(r, i));
    }
    longest = std::max(longest, high[r] - low[r]);
  }
  const double wide = near + (E::order == 2 ? 0.5 * longest : 0.0);
  for (int r = 0; r < D; ++r)
    if (X[r] < low[r] - wide || X[r] > high[r] + wide) return true;
  return false;
}

// The nearest element within the tolerance; the search ends at the first that holds the point to rounding.
template <class E, int D>
std::optional<MaterialPoint> locate_in(const Mesh& mesh, const Position<D>& X) {
  const double size = bounding_size(mesh.X), exact = 1e-14 * size;
  double nearest = tolerance * size;
  std::optional<MaterialPoint> found;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const ElementX<E, D> X_e = gather<E, D>(mesh.X, mesh.elements.col(e).data());
    if (outside_box<E>(X_e, X, tolerance * size)) continue;
    const auto xi = clamped<E>(inverse_map<E>(X_e, X));
    const double distance = (X - position<E>(X_e, xi)).norm();
    if (!(distance <= nearest)) continue;
    if (found && distance == nearest) continue;
    const auto N = E::N(xi);
    found = MaterialPoint{e, {N.begin(), N.end()}};
    nearest = distance;
    if (distance <= exact) break;
  }
  return found;
}

// For every node: whether it lies in the region.
std::vector<char> inside(const Mesh& mesh, const Region& region) {
  std::vector<char> in(mesh.node_count(), 0);
  const int d = mesh.dimension();
  const double near = tolerance * bounding_size(mesh.X);
  const auto mark = [&](auto&& contains) {
    for (int n = 0; n < mesh.node_count(); ++n) in[n] = contains(mesh.X.col(n));
  };
  std::visit(
      [&]<class R>(const R& where) {
        if constexpr (std::is_same_v<R, Box>) {
          const Eigen::ArrayXd low = where.low.head(d).array() - near, high = where.high.head(d).array() + near;
          mark([&](const auto& X) { return (X.array() >= low).all() && (X.array() <= high).all(); });
        } else if constexpr (std::is_same_v<R, Sphere>) {
          mark([&](const auto& X) { return (X - where.centre.head(d)).norm() <= where.radius + near; });
        } else {
          for (const int n : find_group(mesh, where, GroupPart::nodes).nodes) in[n] = 1;
        }
      },
      region);
  return in;
}

bool has(const Group& group, GroupPart part) {
  switch (part) {
    case GroupPart::nodes:
      return !group.nodes.empty();
    case GroupPart::facets:
      return group.facets.cols() > 0;
    default:
      return !group.elements.empty();
  }
}

std::string no_group(const Mesh& mesh, const InGroup& where) {
  std::string names;
  for (const Group& group : mesh.groups) {
    names += (names.empty() ? "\"" : ", \"") + group.name + "\"";
    if (where.dimension && group.name == where.name) names += " of dimension " + std::to_string(group.dimension);
  }
  return "the mesh has no group \"" + where.name + "\"" +
         (where.dimension ? " of dimension " + std::to_string(*where.dimension) : "") + "; " +
         (names.empty() ? "it has no groups at all" : "its groups are " + names);
}

}  // namespace

std::optional<MaterialPoint> locate(const Mesh& mesh, const Vec3& X) {
  return visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    return locate_in<E, D>(mesh, X.head<D>());
  });
}

const Group& find_group(const Mesh& mesh, const InGroup& where, GroupPart part) {
  std::vector<const Group*> named, having;
  for (const Group& group : mesh.groups) {
    if (group.name != where.name || group.dimension != where.dimension.value_or(group.dimension)) continue;
    named.push_back(&group);
    if (has(group, part)) having.push_back(&group);
  }
  if (having.size() == 1) return *having[0];
  if (named.size() == 1) return *named[0];
  if (named.empty()) throw InputError("group", no_group(mesh, where));
  std::string candidates;
  for (const Group* group : named) {
    candidates += (candidates.empty() ? "" : ", ") + std::to_string(group->dimension) + " (" +
                  std::to_string(group->nodes.size()) + " nodes)";
  }
  throw InputError("group", std::to_string(named.size()) + " groups are called \"" + where.name + "\", of dimension " +
                                candidates + ": say which with dimension = " + std::to_string(named[0]->dimension));
}

std::vector<int> nodes_in(const Mesh& mesh, const Region& region) {
  const auto in = inside(mesh, region);
  std::vector<int> nodes;
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (in[n]) nodes.push_back(n);
  }
  return nodes;
}

Eigen::MatrixXi facets_in(const Mesh& mesh, const Region& region) {
  const bool membrane = mesh.dimension() == 3 && info(mesh.kind).dimension == 2;
  if (const auto* named = std::get_if<InGroup>(&region)) {
    const Group& group = find_group(mesh, *named, GroupPart::facets);
    if (group.facets.cols() > 0) return group.facets;
    if (membrane && !group.elements.empty()) return mesh.elements(Eigen::indexing::all, group.elements);
  }
  const auto in = inside(mesh, region);
  const auto chosen_of = [&](const Eigen::MatrixXi& all) -> Eigen::MatrixXi {
    std::vector<int> chosen;
    for (int f = 0; f < all.cols(); ++f) {
      const auto facet = all.col(f);
      if (std::all_of(facet.begin(), facet.end(), [&](int n) { return in[n]; })) chosen.push_back(f);
    }
    return all(Eigen::indexing::all, chosen);
  };
  if (membrane) {
    const Eigen::MatrixXi faces = chosen_of(mesh.elements);
    if (faces.cols() > 0) return faces;
  }
  return chosen_of(boundary_facets(mesh));
}

std::string span_text(const Mesh& mesh) {
  std::ostringstream text;
  const auto write = [&](const Eigen::VectorXd& corner) {
    for (Eigen::Index i = 0; i < corner.size(); ++i) text << (i == 0 ? "[" : ", ") << corner[i];
    text << ']';
  };
  text << "it spans ";
  write(mesh.X.rowwise().minCoeff());
  text << " to ";
  write(mesh.X.rowwise().maxCoeff());
  text << " m";
  return text.str();
}

}  // namespace sim
