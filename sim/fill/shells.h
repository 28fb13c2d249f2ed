// The shells of a closed surface, made to face outwards.
#pragma once

#include <Eigen/Core>

namespace sim {

// What was found, and what was mended.
struct Shells {
  Eigen::Matrix3Xi triangles;  // counter-clockwise seen from outside
  int count = 0;               // parts that share no edge
  int turned = 0;              // triangles that faced the other way than most of their shell
  int inside_out = 0;          // shells that faced inwards and enclose what they should
  int cavities = 0;            // shells that face inwards inside of another one
  int open_edges = 0;          // of one triangle
  int crowded_edges = 0;       // of more than two
};

// Triangles of one shell are turned as most of its area faces, along edges that two of them share. A closed shell that
// faces inwards is turned, unless it lies inside of another one: then it is the wall of a cavity.
Shells face_outwards(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xi& triangles);

}  // namespace sim
