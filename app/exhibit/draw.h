// What several exhibits draw.
#pragma once

#include <Eigen/Core>

#include "render/sheet.h"

namespace app {

inline render::Spot spot(const Eigen::Vector2d& x) {
  return {x.x(), x.y()};
}

// The columns of x, closed.
std::vector<render::Spot> polygon(const Eigen::MatrixXd& x);

// Widens the ranges of a diagram so that the columns of x are inside, with a margin (a share of the extent).
void cover(const Eigen::MatrixXd& x, double margin, render::Diagram& diagram);

// The image of a circle about `centre` under A.
std::vector<render::Spot> ellipse(const Eigen::Vector2d& centre, const Eigen::Matrix2d& A, double radius);

// Arrows of forces (2 x n) at places (2 x n), the longest `length` long; no arrow for what is less than 2 % of it.
void add_forces(const Eigen::MatrixXd& places, const Eigen::MatrixXd& forces, double length, double largest,
                render::Ink ink, render::Diagram& diagram);

// A light colour between white and blue for a share in [0, 1]: dark lines and letters over it can be read.
std::array<int, 3> tint(double share);

}  // namespace app
