#include "sim/contact/candidates.h"

#include <algorithm>

namespace sim {

BroadPhase::BroadPhase(const Skin& skin, const Eigen::Matrix3Xd& x) : skin_(skin) {
  std::vector<Vec3> centres;
  for (const Skin::Part& part : skin.parts) {
    centres.clear();
    for (int e = part.edges.first; e < part.edges.last; ++e)
      centres.emplace_back((x.col(skin.edges[e][0]) + x.col(skin.edges[e][1])) / 2);
    edge_trees_.emplace_back(centres);
    centres.clear();
    for (int f = part.faces.first; f < part.faces.last; ++f) {
      Vec3 sum = Vec3::Zero();
      for (int i = 0; i < skin.corners(); ++i) sum += x.col(skin.faces[f][i]);
      centres.emplace_back(sum / skin.corners());
    }
    face_trees_.emplace_back(centres);
  }
}

void BroadPhase::refit(Boxes& boxes) const {
  boxes.edges.resize(skin_.edges.size());
  boxes.faces.resize(skin_.faces.size());
  for (std::size_t e = 0; e < skin_.edges.size(); ++e)
    boxes.edges[e] = boxes.points[skin_.edges[e][0]].merged(boxes.points[skin_.edges[e][1]]);
  for (std::size_t f = 0; f < skin_.faces.size(); ++f) {
    boxes.faces[f] = boxes.points[skin_.faces[f][0]];
    for (int i = 1; i < skin_.corners(); ++i) boxes.faces[f].extend(boxes.points[skin_.faces[f][i]]);
  }
  boxes.edge_tree.resize(skin_.parts.size());
  boxes.face_tree.resize(skin_.parts.size());
  for (std::size_t k = 0; k < skin_.parts.size(); ++k) {
    const auto part = [](const auto& list, const Span& span) {
      return std::span<const Bounds>(list).subspan(span.first, span.size());
    };
    edge_trees_[k].refit(part(boxes.edges, skin_.parts[k].edges), boxes.edge_tree[k]);
    face_trees_[k].refit(part(boxes.faces, skin_.parts[k].faces), boxes.face_tree[k]);
  }
}

namespace {

Bounds grown(const Bounds& bounds, double by) {
  return Bounds(bounds.min() - Vec3::Constant(by), bounds.max() + Vec3::Constant(by));
}

bool shares_a_point(const std::array<int, 3>& face, int point) {
  return face[0] == point || face[1] == point || face[2] == point;
}

bool share_a_point(const std::array<int, 2>& a, const std::array<int, 2>& b) {
  return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

}  // namespace

bool BroadPhase::find(const std::vector<Couple>& couples, std::size_t most, Boxes& boxes,
                      std::vector<Candidate>& found) const {
  found.clear();
  refit(boxes);
  const PairKind point_face = skin_.D == 2 ? PairKind::point_edge : PairKind::point_triangle;
  for (std::size_t c = 0; c < couples.size(); ++c) {
    const Couple& couple = couples[c];
    const double reach = couple.dh + couple.xi;
    const auto points_to_faces = [&](int of, int to) {
      if (boxes.face_tree[to].empty()) return;
      const Bounds all = grown(boxes.face_tree[to][0], reach);
      const int first_face = skin_.parts[to].faces.first;
      for (int p = skin_.parts[of].points.first; p < skin_.parts[of].points.last && found.size() <= most; ++p) {
        if (!all.intersects(boxes.points[p])) continue;
        const Bounds query = grown(boxes.points[p], reach);
        face_trees_[to].visit(boxes.face_tree[to], query, [&](int item) {
          const int face = first_face + item;
          if (!query.intersects(boxes.faces[face]) || shares_a_point(skin_.faces[face], p)) return;
          found.push_back({point_face, p, face, static_cast<int>(c)});
        });
      }
    };
    points_to_faces(couple.a, couple.b);
    if (couple.a != couple.b) points_to_faces(couple.b, couple.a);
    if (skin_.D == 2 || boxes.edge_tree[couple.b].empty()) continue;
    const Bounds all = grown(boxes.edge_tree[couple.b][0], reach);
    const int first_edge = skin_.parts[couple.b].edges.first;
    for (int e = skin_.parts[couple.a].edges.first; e < skin_.parts[couple.a].edges.last && found.size() <= most; ++e) {
      if (!all.intersects(boxes.edges[e])) continue;
      const Bounds query = grown(boxes.edges[e], reach);
      edge_trees_[couple.b].visit(boxes.edge_tree[couple.b], query, [&](int item) {
        const int f = first_edge + item;
        if ((couple.a == couple.b && f <= e) || !query.intersects(boxes.edges[f])) return;
        if (share_a_point(skin_.edges[e], skin_.edges[f])) return;
        found.push_back({PairKind::edge_edge, e, f, static_cast<int>(c)});
      });
    }
  }
  return found.size() <= most;
}

int points_of(const Skin& skin, const Candidate& candidate, int* points) {
  if (candidate.kind == PairKind::edge_edge) {
    const auto &e = skin.edges[candidate.first], &f = skin.edges[candidate.second];
    points[0] = e[0], points[1] = e[1], points[2] = f[0], points[3] = f[1];
    return 4;
  }
  points[0] = candidate.first;
  for (int i = 0; i < skin.corners(); ++i) points[1 + i] = skin.faces[candidate.second][i];
  return 1 + skin.corners();
}

}  // namespace sim
