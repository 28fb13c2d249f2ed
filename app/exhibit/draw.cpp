#include "app/exhibit/draw.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

std::vector<render::Spot> polygon(const Eigen::MatrixXd& x) {
  std::vector<render::Spot> points;
  for (Eigen::Index a = 0; a < x.cols(); ++a) points.push_back(spot(x.col(a)));
  return points;
}

void cover(const Eigen::MatrixXd& x, double margin, render::Diagram& diagram) {
  const Eigen::Vector2d low = x.rowwise().minCoeff(), high = x.rowwise().maxCoeff();
  const double room = margin * (high - low).maxCoeff();
  diagram.x = {low.x() - room, high.x() + room};
  diagram.y = {low.y() - room, high.y() + room};
}

std::vector<render::Spot> ellipse(const Eigen::Vector2d& centre, const Eigen::Matrix2d& A, double radius) {
  constexpr int corners = 64;
  std::vector<render::Spot> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back(spot(centre + radius * A * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return points;
}

void add_forces(const Eigen::MatrixXd& places, const Eigen::MatrixXd& forces, double length, double largest,
                render::Ink ink, render::Diagram& diagram) {
  for (Eigen::Index a = 0; a < places.cols(); ++a) {
    if (forces.col(a).norm() < 0.02 * largest) continue;
    diagram.darts.push_back({spot(places.col(a)), spot(places.col(a) + length / largest * forces.col(a)), ink});
  }
}

std::array<int, 3> tint(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  const auto mixed = [&](double low, double high) { return static_cast<int>(std::lround(low + s * (high - low))); };
  return {mixed(252, 120), mixed(253, 165), mixed(255, 240)};
}

}  // namespace app
