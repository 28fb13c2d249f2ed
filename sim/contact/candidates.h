// The pairs of primitives that can come within reach of each other while every point stays inside its box.
#pragma once

#include <vector>

#include "sim/contact/box_tree.h"
#include "sim/contact/skin.h"
#include "sim/contact/step_limit.h"

namespace sim {

// Two parts that may touch (the same twice: with itself), and the rules between them.
struct Couple {
  int a, b;
  double dh, kappa;  // m, Pa
  double xi = 0;     // m
};

struct Candidate {
  PairKind kind;
  int first, second;  // a point and a face, or two edges
  int couple;
};

// What the search works on, and its scratch.
struct Boxes {
  std::vector<Bounds> points, edges, faces;
  std::vector<std::vector<Bounds>> edge_tree, face_tree;  // of each part
};

class BroadPhase {
 public:
  // The skin must outlive it. x: places of the points at rest.
  BroadPhase(const Skin& skin, const Eigen::Matrix3Xd& x);

  // Calls f(couple, edge, face) for every edge of one side and face of the other whose boxes meet; in the plane both
  // are faces.
  template <class F>
  void visit_edges_and_faces(const std::vector<Couple>& couples, Boxes& boxes, const F& f) const {
    refit(boxes);
    for (std::size_t c = 0; c < couples.size(); ++c)
      for (const bool turned : {false, true}) {
        const int of = turned ? couples[c].b : couples[c].a, to = turned ? couples[c].a : couples[c].b;
        if (turned && (couples[c].a == couples[c].b || skin_.D == 2)) continue;
        const Span edges = skin_.D == 2 ? skin_.parts[of].faces : skin_.parts[of].edges;
        for (int e = edges.first; e < edges.last; ++e)
          face_trees_[to].visit(boxes.face_tree[to], skin_.D == 2 ? boxes.faces[e] : boxes.edges[e],
                                [&](int item) { f(static_cast<int>(c), e, skin_.parts[to].faces.first + item); });
      }
  }

  // All candidates of the couples, in a fixed order, for points in boxes.points, which the caller has set. Stops, and
  // returns false, when there are more than `most`.
  bool find(const std::vector<Couple>& couples, std::size_t most, Boxes& boxes, std::vector<Candidate>& found) const;

 private:
  void refit(Boxes& boxes) const;

  const Skin& skin_;
  std::vector<BoxTree> edge_trees_, face_trees_;
};

// The points of a candidate, in the order of its kind; returns how many.
int points_of(const Skin& skin, const Candidate& candidate, int* points);

}  // namespace sim
