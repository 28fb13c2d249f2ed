// The lattice of body-centred cubes, whose tets all have one shape: edges a and sqrt(3)/2 a, dihedral angles 60 and 90
// degrees. Vertices have whole coordinates in units of a/2, all even or all odd.
#pragma once

#include <Eigen/Core>
#include <array>

#include "sim/math/vec3.h"

namespace sim {

struct Lattice {
  Vec3 origin = {0, 0, 0};  // m, of the coordinates
  double a = 1;             // m, the side of a cube
  std::array<int, 3> n{};   // cubes along each axis

  // Cubes of side a that hold the box from `low` to `high` with one to spare on every side.
  static Lattice around(const Vec3& low, const Vec3& high, double a);

  int even_count() const { return (n[0] + 1) * (n[1] + 1) * (n[2] + 1); }
  int vertex_count() const { return even_count() + n[0] * n[1] * n[2]; }
  // Numbers of vertices: the even ones first.
  int number(const Eigen::Vector3i& c) const;
  Eigen::Vector3i coordinates(int vertex) const;
  Vec3 place(int vertex) const { return origin + a / 2 * coordinates(vertex).cast<double>(); }
  bool is_long(int v, int w) const { return (v < even_count()) == (w < even_count()); }

  // Calls f(std::array<int, 4>) for every tet, counter-clockwise: around each long edge between even vertices there are
  // four, whose other long edges make a square of odd vertices.
  template <class F>
  void visit_tets(const F& f) const {
    for (int v = 0; v < even_count(); ++v)
      for (int axis = 0; axis < 3; ++axis) visit_tets_at(coordinates(v), axis, f);
  }
  // Calls f(w) for every vertex that shares an edge with v.
  template <class F>
  void visit_neighbours(int v, const F& f) const {
    const Eigen::Vector3i c = coordinates(v);
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-2, 2}) call_inside(c + step * Eigen::Vector3i::Unit(axis), f);
    for (int k = 0; k < 8; ++k)
      call_inside(c + Eigen::Vector3i((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1), f);
  }

 private:
  bool holds(const Eigen::Vector3i& c) const {
    return (c.array() >= 0).all() && c[0] <= 2 * n[0] && c[1] <= 2 * n[1] && c[2] <= 2 * n[2];
  }
  template <class F>
  void call_inside(const Eigen::Vector3i& c, const F& f) const {
    if (holds(c)) f(number(c));
  }
  template <class F>
  void visit_tets_at(const Eigen::Vector3i& low, int axis, const F& f) const {
    using Eigen::Vector3i;
    const Vector3i along = Vector3i::Unit(axis), b = Vector3i::Unit((axis + 1) % 3), c = Vector3i::Unit((axis + 2) % 3);
    const Vector3i high = low + 2 * along, middle = low + along;
    const std::array<Vector3i, 4> square = {middle + b + c, middle - b + c, middle - b - c, middle + b - c};
    if (!holds(high)) return;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3i &r = square[k], &s = square[(k + 1) % 4];
      if (holds(r) && holds(s)) f(std::array<int, 4>{number(low), number(r), number(s), number(high)});
    }
  }
};

}  // namespace sim
