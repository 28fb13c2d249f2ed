#include "sim/fill/fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "sim/fill/lattice.h"
#include "sim/fill/split.h"
#include "sim/fill/winding.h"
#include "sim/fill/wrapping.h"
#include "sim/mesh/check.h"
#include "sim/mesh/components.h"
#include "sim/mesh/dihedral.h"
#include "sim/mesh/input_error.h"

namespace sim {
namespace {

constexpr double most_vertices = 4e6;  // of the lattice: minutes
constexpr double near_long = 0.24999, near_short = 0.41189;

class Stuffing {
 public:
  Stuffing(const Lattice& lattice, const Winding& winding) : lattice_(lattice), winding_(winding) {
    sign_.resize(static_cast<std::size_t>(lattice.vertex_count()));
    node_.assign(sign_.size(), -1);
    for (int v = 0; v < lattice.vertex_count(); ++v) {
      place_.push_back(lattice.place(v));
      sign_[v] = winding.at(place_.back()) > 0.5 ? 1 : -1;
    }
    find_cuts();
    for (int v = 0; v < lattice.vertex_count(); ++v) warp(v);
  }

  Mesh mesh() {
    const Cutting cutting{[this](int v) { return int{sign_[v]}; }, [this](int v) { return node_of(v); },
                          [this](int v, int w) { return cut_node(v, w); },
                          [this](int a, int b, int m) { return crosses(a, b, m); },
                          [this](int node) { return nodes_[node]; }};
    std::vector<std::array<int, 4>> tets;
    lattice_.visit_tets([&](const std::array<int, 4>& tet) {
      if (is_outside(tet)) return;
      split_tet(tet, cutting, tets);
    });
    Mesh mesh;
    mesh.kind = ElementKind::tet4;
    mesh.X.resize(3, static_cast<Eigen::Index>(nodes_.size()));
    for (std::size_t i = 0; i < nodes_.size(); ++i) mesh.X.col(static_cast<Eigen::Index>(i)) = nodes_[i];
    mesh.elements.resize(4, static_cast<Eigen::Index>(tets.size()));
    for (std::size_t e = 0; e < tets.size(); ++e) mesh.elements.col(static_cast<Eigen::Index>(e)) = oriented(tets[e]);
    return mesh;
  }

 private:
  struct Cut {
    Vec3 place;
    double share;  // of the edge, from its first vertex
    int node = -1;
  };
  using Edge = std::pair<int, int>;  // first < second

  Cut* find(int v, int w) {
    const auto found = cuts_.find(std::minmax(v, w));
    return found == cuts_.end() ? nullptr : &found->second;
  }

  // Where the boundary crosses edges, by halving: between its two sides there is nothing else to go by.
  void find_cuts() {
    constexpr int halvings = 36;
    for (int v = 0; v < lattice_.vertex_count(); ++v)
      lattice_.visit_neighbours(v, [&](int w) {
        if (w < v || sign_[v] == sign_[w]) return;
        double low = 0, high = 1;
        for (int k = 0; k < halvings; ++k) {
          const double middle = (low + high) / 2;
          const bool inside = winding_.at(place_[v] + middle * (place_[w] - place_[v])) > 0.5;
          (inside == (sign_[v] > 0) ? low : high) = middle;
        }
        const double share = (low + high) / 2;
        cuts_[{v, w}] = {place_[v] + share * (place_[w] - place_[v]), share};
      });
  }

  // Moves a vertex onto the nearest cut that is too near to it: its edges are cut no more.
  void warp(int v) {
    double least = std::numeric_limits<double>::infinity();
    Vec3 nearest = place_[v];
    lattice_.visit_neighbours(v, [&](int w) {
      const Cut* cut = sign_[w] * sign_[v] < 0 ? find(v, w) : nullptr;
      if (cut == nullptr) return;
      const bool is_long = lattice_.is_long(v, w);
      const double share = v < w ? cut->share : 1 - cut->share;
      const double distance = share * (is_long ? 1.0 : 0.8660254037844386);
      if (share >= (is_long ? near_long : near_short) || distance >= least) return;
      least = distance;
      nearest = cut->place;
    });
    if (!(least < std::numeric_limits<double>::infinity())) return;
    place_[v] = nearest;
    sign_[v] = 0;
  }

  // Nothing inside; four vertices on the surface have it where the middle is inside.
  bool is_outside(const std::array<int, 4>& tet) const {
    const auto [low, high] = std::minmax({sign_[tet[0]], sign_[tet[1]], sign_[tet[2]], sign_[tet[3]]});
    if (high != 0) return high < 0;
    if (low < 0) return true;
    return !(winding_.at((place_[tet[0]] + place_[tet[1]] + place_[tet[2]] + place_[tet[3]]) / 4) > 0.5);
  }

  int add_node(const Vec3& place) {
    nodes_.push_back(place);
    return static_cast<int>(nodes_.size()) - 1;
  }
  int node_of(int v) {
    if (node_[v] < 0) node_[v] = add_node(place_[v]);
    return node_[v];
  }
  int cut_node(int v, int w) {
    Cut& cut = *find(v, w);
    if (cut.node < 0) cut.node = add_node(cut.place);
    return cut.node;
  }

  // The same for both tets of a face: to the cut of its long edge, which is the shorter way; where a and b are the long
  // edge itself, by the parity of its ends.
  bool crosses(int a, int b, int m) const {
    if (lattice_.is_long(a, m)) return false;
    if (lattice_.is_long(b, m)) return true;
    const Eigen::Vector3i from = lattice_.coordinates(m), to = lattice_.coordinates(a);
    return (to.array() > from.array()).count() % 2 == 1;
  }

  Eigen::Vector4i oriented(const std::array<int, 4>& t) const {
    const Vec3 a = nodes_[t[1]] - nodes_[t[0]], b = nodes_[t[2]] - nodes_[t[0]], c = nodes_[t[3]] - nodes_[t[0]];
    if (a.cross(b).dot(c) > 0) return {t[0], t[1], t[2], t[3]};
    return {t[0], t[2], t[1], t[3]};
  }

  const Lattice& lattice_;
  const Winding& winding_;
  std::vector<signed char> sign_;  // of the vertices
  std::vector<Vec3> place_;
  std::vector<int> node_;  // -1: none
  std::map<Edge, Cut> cuts_;
  std::vector<Vec3> nodes_;
};

double volume_of(const Mesh& mesh, const std::vector<int>& elements) {
  double sum = 0;
  for (const int e : elements) {
    const auto t = mesh.elements.col(e);
    const Vec3 o = mesh.X.col(t[0]), a = mesh.X.col(t[1]), b = mesh.X.col(t[2]), c = mesh.X.col(t[3]);
    sum += (a - o).cross(b - o).dot(c - o) / 6;
  }
  return sum;
}

// Leaves the parts out that are too small to be meant: what is left of tips that are thinner than the lattice. Of many
// parts that are alike, all are meant.
int drop_crumbs(Mesh& mesh) {
  constexpr double share = 0.01;  // of the largest one
  const std::vector<Component> parts = components(mesh);
  std::vector<double> volumes;
  for (const Component& part : parts) volumes.push_back(volume_of(mesh, part.elements));
  const double largest = *std::max_element(volumes.begin(), volumes.end());
  std::vector<int> kept;
  int dropped = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (volumes[k] < share * largest)
      ++dropped;
    else
      kept.insert(kept.end(), parts[k].elements.begin(), parts[k].elements.end());
  }
  if (dropped == 0) return 0;
  std::sort(kept.begin(), kept.end());
  mesh.elements = Eigen::MatrixXi(mesh.elements(Eigen::indexing::all, kept));
  check_and_orient(mesh);  // drops the nodes of the crumbs
  return dropped;
}

void check_size(const Vec3& extent, double size) {
  const auto vertices = [&](double edge) { return 2 * (extent.array() / edge + 3).prod(); };
  if (vertices(size) <= most_vertices) return;
  double least = size;
  while (vertices(least) > most_vertices) least *= 1.01;
  std::ostringstream message;
  message << std::setprecision(3) << "makes a lattice of more than 4e6 vertices: the surface is "
          << extent.maxCoeff() / size << " times as long, and may be " << extent.maxCoeff() / least
          << " times; a file in millimetres takes mesh.scale = 0.001";
  throw InputError("mesh.size", message.str());
}

}  // namespace

Filling fill(const Mesh& surface, double size) {
  const Eigen::Matrix3Xd X = surface.X;
  const Vec3 low = X.rowwise().minCoeff(), high = X.rowwise().maxCoeff();
  check_size(high - low, size);
  Filling filling;
  filling.shells = face_outwards(X, surface.elements);
  const Winding winding(X, filling.shells.triangles);
  const Lattice lattice = Lattice::around(low, high, size);
  filling.mesh = Stuffing(lattice, winding).mesh();
  if (filling.mesh.element_count() == 0)
    throw InputError("mesh.surface",
                     filling.shells.open_edges > 0
                         ? "encloses nothing: " + std::to_string(filling.shells.open_edges) + " of its edges are open"
                         : "encloses nothing as large as mesh.size");
  filling.crumbs = drop_crumbs(filling.mesh);
  const Eigen::Matrix3Xd inside = filling.mesh.X;
  filling.spanned = (inside.rowwise().maxCoeff() - inside.rowwise().minCoeff()).maxCoeff() / (high - low).maxCoeff();
  const Wrapping wrapping = wrap(surface, filling.mesh);
  filling.mesh.groups = inherit_groups(surface, wrapping);
  filling.lost = count_lost(surface, filling.mesh, wrapping);
  filling.smallest_angle = smallest_dihedral(filling.mesh);
  return filling;
}

}  // namespace sim
