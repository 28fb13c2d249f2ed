#include "sim/fill/shells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "sim/fill/winding.h"

namespace sim {
namespace {

// One side of a triangle: the edge from its lower to its higher vertex, and whether the triangle goes the other way.
struct Side {
  int triangle;
  bool back;
};
using Edges = std::map<std::array<int, 2>, std::vector<Side>>;

Edges edges_of(const Eigen::Matrix3Xi& triangles) {
  Edges edges;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles(k, t), b = triangles((k + 1) % 3, t);
      edges[{std::min(a, b), std::max(a, b)}].push_back({static_cast<int>(t), a > b});
    }
  return edges;
}

struct Neighbour {
  int triangle;
  bool opposed;  // it has to be turned to face the same way
};

std::vector<std::vector<Neighbour>> neighbours_of(const Edges& edges, Eigen::Index count) {
  std::vector<std::vector<Neighbour>> neighbours(static_cast<std::size_t>(count));
  for (const auto& [edge, sides] : edges) {
    if (sides.size() != 2) continue;
    const bool opposed = sides[0].back == sides[1].back;
    neighbours[sides[0].triangle].push_back({sides[1].triangle, opposed});
    neighbours[sides[1].triangle].push_back({sides[0].triangle, opposed});
  }
  return neighbours;
}

// The triangles of a shell from the first one on, and for each whether it faces the other way than that.
struct Shell {
  std::vector<int> triangles;
  std::vector<char> opposed;
};

std::vector<Shell> shells_of(const std::vector<std::vector<Neighbour>>& neighbours) {
  std::vector<char> seen(neighbours.size(), 0);
  std::vector<Shell> shells;
  for (std::size_t first = 0; first < neighbours.size(); ++first) {
    if (seen[first]) continue;
    Shell shell{{static_cast<int>(first)}, {0}};
    seen[first] = 1;
    for (std::size_t i = 0; i < shell.triangles.size(); ++i)
      for (const Neighbour& next : neighbours[shell.triangles[i]]) {
        if (seen[next.triangle]) continue;
        seen[next.triangle] = 1;
        shell.triangles.push_back(next.triangle);
        shell.opposed.push_back(shell.opposed[i] != static_cast<char>(next.opposed));
      }
    shells.push_back(std::move(shell));
  }
  return shells;
}

void turn(Eigen::Matrix3Xi& triangles, int triangle) {
  std::swap(triangles(1, triangle), triangles(2, triangle));
}

// Turns the smaller part of the area to face as the larger one does. Returns how many triangles were turned.
int turn_minority(const Eigen::Matrix3Xd& X, const Shell& shell, Eigen::Matrix3Xi& triangles) {
  std::array<double, 2> area{};
  for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
    const auto t = triangles.col(shell.triangles[i]);
    const Vec3 a = X.col(t[0]), b = X.col(t[1]), c = X.col(t[2]);
    area[shell.opposed[i]] += (b - a).cross(c - a).norm() / 2;
  }
  const char minority = area[0] < area[1] ? 0 : 1;
  int turned = 0;
  for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
    if (shell.opposed[i] != minority) continue;
    turn(triangles, shell.triangles[i]);
    ++turned;
  }
  return turned;
}

Eigen::Matrix3Xi part(const Eigen::Matrix3Xi& triangles, const Shell& shell) {
  return triangles(Eigen::indexing::all, shell.triangles);
}

// V = sum over triangles of det(a, b, c)/6, from a vertex of the shell.
double volume(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xi& triangles) {
  const Vec3 origin = X.col(triangles(0, 0));
  double sum = 0;
  for (const auto& t : triangles.colwise()) {
    const Vec3 a = X.col(t[0]) - origin, b = X.col(t[1]) - origin, c = X.col(t[2]) - origin;
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

// Whether a vertex of this shell is inside of one of the others, whichever way they face.
bool is_inside_another(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xi& triangles, const std::vector<Shell>& shells,
                       std::size_t which) {
  const Vec3 x = X.col(triangles(0, shells[which].triangles[0]));
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (k == which) continue;
    const Eigen::Matrix3Xi other = part(triangles, shells[k]);
    if (std::abs(Winding(X, other).at(x)) > 0.5) return true;
  }
  return false;
}

}  // namespace

Shells face_outwards(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xi& triangles) {
  Shells result;
  result.triangles = triangles;
  const Edges edges = edges_of(triangles);
  for (const auto& [edge, sides] : edges) {
    result.open_edges += sides.size() == 1;
    result.crowded_edges += sides.size() > 2;
  }
  const std::vector<Shell> shells = shells_of(neighbours_of(edges, triangles.cols()));
  result.count = static_cast<int>(shells.size());
  for (const Shell& shell : shells) result.turned += turn_minority(X, shell, result.triangles);
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (volume(X, part(result.triangles, shells[k])) >= 0) continue;
    if (is_inside_another(X, result.triangles, shells, k)) {
      ++result.cavities;
      continue;
    }
    ++result.inside_out;
    for (const int triangle : shells[k].triangles) turn(result.triangles, triangle);
  }
  return result;
}

}  // namespace sim
