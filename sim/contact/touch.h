// The potential of contact, pair by pair:
//   U = sum kappa A m M b(d)
// A point p of a surface feels each face f of the other, less the edges between two faces, plus the points inside that
// other surface, each with its own distance to p: what lies over a flat surface then counts once, wherever it is. [Li
// et al. 2023] An edge is shared equally by its 2 faces, a point by the n around it, so a pair of p and f carries
//   b(p, f) - sum_edges b(p, e)/2 + sum_points b(p, v)/n     (in the plane: b(p, e) - sum_points b(p, v)/2)
// with A = half of the point's area: the points of both sides together carry a pressure of -kappa b' at any resolution.
// Two edges e, f carry b(e, f) with A = edge_share pi/2 a_e a_f/(l_e l_f), which adds up to edge_share of the surface
// where edges of every direction lie across each other. [Buffon 1777] Where sharp edges cross they carry all of the
// load. Their share must be about that of points: with a tenth of it, gaps there sink to a tenth, and two boxes turned
// across each other took 40 Newton iterations in a step and more, in place of 5 to 11.
#pragma once

#include "sim/contact/candidates.h"

namespace sim {

constexpr double edge_share = 1;

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
    return couple == other.couple && feature == other.feature && point == other.point && (e > 0) == (other.e > 0);
  }
};

// The contributions of a candidate that is nearer than xi + dh. False: it is at xi or nearer.
bool add_touches(const Skin& skin, const std::vector<Couple>& couples, const Candidate& candidate,
                 const Eigen::Matrix3Xd& x, std::vector<Touch>& touches);

// Gathers equal ones, in the order of their points, and leaves out what adds to nothing.
void gather(std::vector<Touch>& touches);

}  // namespace sim
