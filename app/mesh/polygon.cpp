#include "app/mesh/polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace app {
namespace {

using Point = Eigen::Vector2d;

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Twice the area of the triangle a b c: positive where it turns left.
double twice_area(const Point& a, const Point& b, const Point& c) {
  return cross(b - a, c - a);
}

// The polygon's area vector, twice: the sum of its corners' cross products [Newell].
Eigen::Vector3d twice_area_vector(const std::vector<Eigen::Vector3d>& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  return sum;
}

bool on_one_line(const std::vector<Eigen::Vector3d>& corners, double flat) {
  Eigen::Vector3d far = corners[0];
  for (const Eigen::Vector3d& X : corners) {
    if ((X - corners[0]).norm() > (far - corners[0]).norm()) far = X;
  }
  return std::ranges::all_of(
      corners, [&](const Eigen::Vector3d& X) { return (X - corners[0]).cross(far - corners[0]).norm() <= flat; });
}

// In the plane across the normal, so that the polygon turns left.
std::vector<Point> in_its_plane(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
  std::vector<Point> flat;
  for (const Eigen::Vector3d& X : corners) flat.emplace_back(u.dot(X - corners[0]), v.dot(X - corners[0]));
  return flat;
}

class Clipping {
 public:
  // flat: twice an area that is none.
  Clipping(std::vector<Point> corners, double flat) : X_(std::move(corners)), left_(X_.size()), flat_(flat) {
    std::iota(left_.begin(), left_.end(), 0);
  }

  std::optional<std::vector<std::array<int, 3>>> triangles() {
    std::vector<std::array<int, 3>> result;
    std::size_t at = 1, tried = 0;
    while (left_.size() >= 3 && !(area_left() <= flat_)) {
      if (tried > left_.size()) return std::nullopt;
      at %= left_.size();
      if (!is_ear(at)) {
        ++at;
        ++tried;
        continue;
      }
      result.push_back({neighbour(at, -1), left_[at], neighbour(at, 1)});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    if (left_.size() >= 3 && area_left() < -flat_) return std::nullopt;
    return result;
  }

 private:
  const Point& X(int corner) const { return X_[static_cast<std::size_t>(corner)]; }

  int neighbour(std::size_t at, int step) const {
    const std::size_t n = left_.size();
    return left_[step < 0 ? (at + n - 1) % n : (at + 1) % n];
  }

  double area_left() const {
    double area = 0;
    for (std::size_t i = 1; i + 1 < left_.size(); ++i) area += twice_area(X(left_[0]), X(left_[i]), X(left_[i + 1]));
    return area;
  }

  double turn(std::size_t at) const { return twice_area(X(neighbour(at, -1)), X(left_[at]), X(neighbour(at, 1))); }

  // It turns left, and no corner lies in it or on its edges. Only corners that do not turn left can.
  bool is_ear(std::size_t at) const {
    if (turn(at) <= flat_) return false;
    const int a = neighbour(at, -1), b = left_[at], c = neighbour(at, 1);
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const int p = left_[i];
      if (p == a || p == b || p == c || turn(i) > flat_) continue;
      if (twice_area(X(a), X(b), X(p)) >= 0 && twice_area(X(b), X(c), X(p)) >= 0 && twice_area(X(c), X(a), X(p)) >= 0)
        return false;
    }
    return true;
  }

  std::vector<Point> X_;
  std::vector<int> left_;  // corners that are not cut off yet
  double flat_;
};

}  // namespace

std::optional<std::vector<std::array<int, 3>>> cut_polygon(const std::vector<Eigen::Vector3d>& corners) {
  constexpr double rounding = 1e-14;  // relative to the square of the polygon's size
  double size = 0;
  for (const Eigen::Vector3d& X : corners) size = std::max(size, (X - corners[0]).squaredNorm());
  const double flat = rounding * size;
  const Eigen::Vector3d area = twice_area_vector(corners);
  if (on_one_line(corners, flat)) return std::vector<std::array<int, 3>>{};
  if (!(area.norm() > flat)) return std::nullopt;
  return Clipping(in_its_plane(corners, area), flat).triangles();
}

}  // namespace app
