// The potential of contact, pair by pair:
//   U = sum kappa A m M b(d)
// A point p of a surface feels each face f of the other, less the edges between two faces, plus the points inside that
// other surface, each with its own distance to p: what lies over a flat surface then counts once, wherever it is. [Li
// et al. 2023] An edge is shared equally by its 2 faces, a point by the n around it, so a pair of p and f carries
//   b(p, f) - sum_edges b(p, e)/2 + sum_points b(p, v)/n     (in the plane: b(p, e) - sum_points b(p, v)/2)
// with A = half of the point's area in the plane, where the points of both sides together carry all of the pressure
// -kappa b', and a quarter in space, where edges carry edge_share of it. Of two edges each is taken less half of its
// ends inside its surface, as edges in the plane are:
//   (e - sum_u u/2)(f - sum_v v/2) = b(e, f) - sum_v b(e, v)/2 - sum_u b(u, f)/2 + sum_uv b(u, v)/4
// with A = edge_share pi/2 a_e a_f/(l_e l_f). So an edge that slides over a point counts the edges there that it
// crosses, before, on it and after; without the ends it counted all of them while it was within dh of that point, and
// where meshes lie aligned gaps were of five times the stiffness. This adds up to edge_share of the surface where edges
// of every direction lie across each other [Buffon 1777], and to 0.84 of that where boxes lie aligned. Where sharp
// edges cross they carry all of the load. Their share must be about that of points: with a tenth of it, gaps there sink
// to a tenth, and two boxes turned across each other took 40 Newton iterations in a step and more, in place of 5 to 11.
#pragma once

#include "sim/contact/candidates.h"

namespace sim {

constexpr double edge_share = 0.5;  // in space

// What depends on one distance. Points that carry it, in the order of sim/contact/distance.h; four for edges that are
// nearly parallel, whose mollifier moves with all of them.
struct Touch {
  Feature feature;
  std::array<int, 4> point;  // of the skin; ascending where the order is free
  int couple;
  double weight;  // kappa A m [N]
  double e = 0;   // > 0: where the mollifier begins, of the edges point[0]-point[1] and point[2]-point[3]
  std::array<int, 4> near = {0, 1, 2, 3};  // which of the points carry the distance
  double d = 0;                            // m

  bool same(const Touch& other) const {
    return couple == other.couple && feature == other.feature && point == other.point && (e > 0) == (other.e > 0) &&
           near == other.near;
  }
};

// The contributions of a candidate that is nearer than xi + dh. False: it is at xi or nearer.
bool add_touches(const Skin& skin, const std::vector<Couple>& couples, const Candidate& candidate,
                 const Eigen::Matrix3Xd& x, std::vector<Touch>& touches);

// Gathers equal ones, in the order of their points, and leaves out what adds to nothing. What two nearly parallel edges
// carry stands together.
void gather(std::vector<Touch>& touches);

}  // namespace sim
