#include "sim/fill/split.h"

#include <algorithm>
#include <utility>

#include "sim/mesh/dihedral.h"

namespace sim {
namespace {

using Tet = std::array<int, 4>;

// Between two triangles p and q whose corners are joined: three tets, by the order in which their corners are taken.
// The side between corners i and j is cut from p of the earlier to q of the later one.
struct Wedge {
  std::array<int, 3> p, q;
};

std::array<Tet, 3> tets_of(const Wedge& w, const std::array<int, 3>& order) {
  const auto [a, b, c] = order;
  return {{{w.p[a], w.p[b], w.p[c], w.q[c]}, {w.p[a], w.p[b], w.q[b], w.q[c]}, {w.p[a], w.q[a], w.q[b], w.q[c]}}};
}

double worst_angle(const std::array<Tet, 3>& tets, const Cutting& cutting) {
  double worst = 180;
  for (const Tet& tet : tets)
    worst = std::min(worst, smallest_dihedral({cutting.place(tet[0]), cutting.place(tet[1]), cutting.place(tet[2]),
                                               cutting.place(tet[3])}));
  return worst;
}

// How a side is cut: from p of corner i to q of corner j.
struct Diagonal {
  int i, j;
};

// Of the orders that cut the sides as their neighbours do, the one with the best angles.
void add_wedge(const Wedge& wedge, const std::vector<Diagonal>& given, const Cutting& cutting, std::vector<Tet>& tets) {
  std::array<int, 3> order = {0, 1, 2};
  double best = -1;
  std::array<Tet, 3> chosen{};
  do {
    const auto rank = [&](int corner) { return std::find(order.begin(), order.end(), corner) - order.begin(); };
    const bool fits = std::all_of(given.begin(), given.end(), [&](Diagonal d) { return rank(d.i) < rank(d.j); });
    const std::array<Tet, 3> candidate = tets_of(wedge, order);
    const double angle = fits ? worst_angle(candidate, cutting) : -1;
    if (angle <= best) continue;
    best = angle;
    chosen = candidate;
  } while (std::next_permutation(order.begin(), order.end()));
  tets.insert(tets.end(), chosen.begin(), chosen.end());
}

using Vertices = std::vector<int>;

Diagonal diagonal(int i, int j, bool crosses) {
  return crosses ? Diagonal{i, j} : Diagonal{j, i};
}

// Three inside, one outside.
void add_without_corner(const Vertices& in, int out, const Cutting& c, std::vector<Tet>& tets) {
  Wedge wedge{};
  for (std::size_t i = 0; i < 3; ++i) {
    wedge.p[i] = c.node(in[i]);
    wedge.q[i] = c.cut(in[i], out);
  }
  std::vector<Diagonal> given;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    given.push_back(diagonal(i, j, c.crosses(in[i], in[j], out)));
  }
  add_wedge(wedge, given, c, tets);
}

// Two inside, two outside: the wedge lies along the edge of those inside.
void add_half(const Vertices& in, const Vertices& out, const Cutting& c, std::vector<Tet>& tets) {
  const Wedge wedge{{c.node(in[0]), c.cut(in[0], out[0]), c.cut(in[0], out[1])},
                    {c.node(in[1]), c.cut(in[1], out[0]), c.cut(in[1], out[1])}};
  add_wedge(wedge, {diagonal(0, 1, c.crosses(in[0], in[1], out[0])), diagonal(0, 2, c.crosses(in[0], in[1], out[1]))},
            c, tets);
}

// Two inside, one outside, one on the surface: a pyramid.
void add_pyramid(const Vertices& in, int out, int on, const Cutting& c, std::vector<Tet>& tets) {
  const int A = c.node(in[0]), B = c.node(in[1]), cA = c.cut(in[0], out), cB = c.cut(in[1], out), top = c.node(on);
  if (c.crosses(in[0], in[1], out)) {
    tets.push_back({A, B, cB, top});
    tets.push_back({A, cB, cA, top});
  } else {
    tets.push_back({A, B, cA, top});
    tets.push_back({B, cB, cA, top});
  }
}

}  // namespace

void split_tet(const std::array<int, 4>& tet, const Cutting& c, std::vector<std::array<int, 4>>& tets) {
  Vertices in, on, out;
  for (const int v : tet) (c.sign(v) > 0 ? in : c.sign(v) < 0 ? out : on).push_back(v);
  if (out.empty()) {
    tets.push_back({c.node(tet[0]), c.node(tet[1]), c.node(tet[2]), c.node(tet[3])});
  } else if (in.size() == 3) {
    add_without_corner(in, out[0], c, tets);
  } else if (in.size() == 2 && out.size() == 2) {
    add_half(in, out, c, tets);
  } else if (in.size() == 2) {
    add_pyramid(in, out[0], on[0], c, tets);
  } else if (in.size() == 1) {
    // The corner inside, cut off; vertices on the surface stay where they are.
    Tet corner = {c.node(in[0]), 0, 0, 0};
    std::size_t next = 1;
    for (const int v : out) corner[next++] = c.cut(in[0], v);
    for (const int v : on) corner[next++] = c.node(v);
    tets.push_back(corner);
  }
}

}  // namespace sim
