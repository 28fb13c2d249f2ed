#include "sim/mesh/refine.h"

#include "sim/element/list.h"
#include "sim/mesh/subdivide.h"

namespace sim {
namespace {

// The middle octahedron of a tetrahedron is cut into four around the shortest of its three diagonals, which keeps the
// shapes of the descendants bounded [Bey 1995; Zhang 1995]. A row: the two ends of a diagonal, then the ring of the
// other middles around it, so that (end, end, ring k, ring k+1) has positive volume. Numbers are those of tet10.
constexpr std::array<std::array<int, 6>, 3> octahedron = {{{4, 9, 5, 6, 7, 8}, {5, 7, 4, 8, 9, 6}, {6, 8, 4, 5, 9, 7}}};

template <class X_e>
std::array<int, 6> shortest_diagonal(const X_e& X) {
  std::array<int, 6> best{};
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& row : octahedron) {
    const auto& [a, b, unused] = Tet10::edges[row[0] - Tet10::corners];
    const auto& [c, d, unused_too] = Tet10::edges[row[1] - Tet10::corners];
    const double length = (X.col(a) + X.col(b) - X.col(c) - X.col(d)).squaredNorm();
    if (length < shortest) {
      shortest = length;
      best = row;
    }
  }
  return best;
}

struct Halve {
  template <class Parent, class Child, int D>
  std::vector<ChildXi<Child>> operator()([[maybe_unused]] const ElementX<Parent, D>& X_e) const {
    constexpr int d = Parent::dimension;
    std::vector<ChildXi<Child>> children;
    // At corner c: the parent shrunk by half towards it.
    for (int c = 0; c < Parent::corners; ++c) {
      ChildXi<Child> xi{};
      for (int i = 0; i < Parent::corners; ++i) {
        for (int k = 0; k < d; ++k) xi[i][k] = (Parent::corner_xi[c][k] + Parent::corner_xi[i][k]) / 2;
      }
      children.push_back(with_middles<Child>(xi));
    }
    if constexpr (Parent::dimension == 2 && Parent::corners == 3) add_inner<Child, Tri6>({{3, 4, 5}}, children);
    if constexpr (Parent::dimension == 3 && Parent::corners == 4) {
      const auto [p, q, r0, r1, r2, r3] = shortest_diagonal(X_e);
      add_inner<Child, Tet10>({{p, q, r0, r1}, {p, q, r1, r2}, {p, q, r2, r3}, {p, q, r3, r0}}, children);
    }
    return children;
  }

 private:
  // Children whose corners are nodes of the quadratic parent.
  template <class Child, class Quadratic>
  static void add_inner(const std::vector<std::array<int, Quadratic::corners>>& corners,
                        std::vector<ChildXi<Child>>& children) {
    const auto node = node_xi<Quadratic>();
    for (const auto& child : corners) {
      ChildXi<Child> xi{};
      for (int i = 0; i < Quadratic::corners; ++i) xi[i] = node[child[i]];
      children.push_back(with_middles<Child>(xi));
    }
  }
};

}  // namespace

Mesh refine(const Mesh& mesh) {
  return visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    return subdivide<E, E, D>(mesh, Halve{});
  });
}

}  // namespace sim
