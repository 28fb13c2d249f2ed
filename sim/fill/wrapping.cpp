#include "sim/fill/wrapping.h"

#include <algorithm>
#include <array>
#include <limits>

#include "sim/contact/distance.h"
#include "sim/fill/carry.h"
#include "sim/math/vec3.h"
#include "sim/mesh/boundary.h"
#include "sim/mesh/components.h"

namespace sim {
namespace {

// Triangles with balls around their middles, which tell most of them apart from the nearest one at once.
class Triangles {
 public:
  explicit Triangles(const Mesh& surface) : surface_(surface) {
    for (int t = 0; t < surface.element_count(); ++t) {
      const std::array<Vec3, 3> X = corners(t);
      const Vec3 middle = (X[0] + X[1] + X[2]) / 3;
      middles_.push_back(middle);
      radii_.push_back(std::max({(X[0] - middle).norm(), (X[1] - middle).norm(), (X[2] - middle).norm()}));
    }
  }

  int nearest(const Vec3& x) const {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < middles_.size(); ++t) {
      const double reach = least + radii_[t];
      if ((middles_[t] - x).squaredNorm() >= reach * reach) continue;
      const std::array<Vec3, 3> X = corners(static_cast<int>(t));
      const Vec3 pair[] = {x, X[0], X[1], X[2]};
      const double d = nearest_point_triangle(pair).d;
      if (d >= least) continue;
      least = d;
      best = static_cast<int>(t);
    }
    return best;
  }

 private:
  std::array<Vec3, 3> corners(int t) const {
    std::array<Vec3, 3> X;
    for (int i = 0; i < 3; ++i) X[i] = surface_.X.col(surface_.elements(i, t));
    return X;
  }

  const Mesh& surface_;
  std::vector<Vec3> middles_;
  std::vector<double> radii_;  // m
};

}  // namespace

Wrapping wrap(const Mesh& surface, const Mesh& solid) {
  Wrapping wrapping{boundary_facets(solid), {}};
  const Triangles triangles(surface);
  for (const auto& f : wrapping.facets.colwise())
    wrapping.nearest.push_back(triangles.nearest((solid.X.col(f[0]) + solid.X.col(f[1]) + solid.X.col(f[2])) / 3));
  return wrapping;
}

std::vector<Group> inherit_groups(const Mesh& surface, const Wrapping& wrapping) {
  std::vector<Group> groups;
  for (const Group& source : surface.groups) {
    if (source.elements.empty()) continue;
    std::vector<Eigen::Index> own;
    for (std::size_t k = 0; k < wrapping.nearest.size(); ++k)
      if (std::binary_search(source.elements.begin(), source.elements.end(), wrapping.nearest[k]))
        own.push_back(static_cast<Eigen::Index>(k));
    Group group{source.name, {}, {}, wrapping.facets(Eigen::indexing::all, own), 2};
    group.nodes.assign(group.facets.reshaped().begin(), group.facets.reshaped().end());
    std::sort(group.nodes.begin(), group.nodes.end());
    group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
    groups.push_back(group);
  }
  return groups;
}

int count_lost(const Mesh& surface, const Mesh& solid, const Wrapping& wrapping) {
  const std::vector<Component> parts = components(surface);
  if (parts.size() == 1) return 0;
  std::vector<char> wraps(static_cast<std::size_t>(surface.element_count()), 0);
  for (const int triangle : wrapping.nearest) wraps[static_cast<std::size_t>(triangle)] = 1;
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(parts.size()));  // of a node of each that wraps nothing
  Eigen::Index count = 0;
  for (const Component& part : parts) {
    if (std::any_of(part.elements.begin(), part.elements.end(), [&](int t) { return wraps[t] != 0; })) continue;
    places.col(count++) = surface.X.col(part.nodes[0]);
  }
  if (count == 0) return 0;
  // What lies inside of others is part of them.
  const std::vector<MaterialPoint> carried = carry(solid, places.leftCols(count));
  return static_cast<int>(std::count_if(carried.begin(), carried.end(),
                                        [](const MaterialPoint& point) { return farthest_outside({point}) > 0; }));
}

}  // namespace sim
