// Quadrature rules on the reference line [-1,1], square, cube, triangle and tetrahedron. All points are interior and
// all weights positive; the weights of a rule sum to the measure of its domain. The degree is that of the polynomials
// which are integrated exactly (per variable for tensor products).
#pragma once

#include <array>
#include <numbers>

#include "sim/element/element.h"

namespace sim {

// Gauss-Legendre with n points has degree 2n - 1 [Abramowitz & Stegun 1964, table 25.4].
inline constexpr std::array<QuadraturePoint<1>, 1> line_1 = {{{{0.0}, 2.0}}};
inline constexpr std::array<QuadraturePoint<1>, 2> line_2 = {
    {{{-std::numbers::inv_sqrt3}, 1.0}, {{std::numbers::inv_sqrt3}, 1.0}}};
inline constexpr std::array<QuadraturePoint<1>, 3> line_3 = {
    {{{-0.77459666924148337704}, 5.0 / 9}, {{0.0}, 8.0 / 9}, {{0.77459666924148337704}, 5.0 / 9}}};

// Products of line_2, degree 3 in every variable; the first variable runs fastest.
constexpr std::array<QuadraturePoint<2>, 4> make_square_4() {
  std::array<QuadraturePoint<2>, 4> rule{};
  for (int i = 0; i < 4; ++i) rule[i] = {{line_2[i & 1].xi[0], line_2[i >> 1].xi[0]}, 1.0};
  return rule;
}
constexpr std::array<QuadraturePoint<3>, 8> make_cube_8() {
  std::array<QuadraturePoint<3>, 8> rule{};
  for (int i = 0; i < 8; ++i) {
    rule[i] = {{line_2[i & 1].xi[0], line_2[(i >> 1) & 1].xi[0], line_2[i >> 2].xi[0]}, 1.0};
  }
  return rule;
}
inline constexpr std::array<QuadraturePoint<2>, 4> square_4 = make_square_4();
inline constexpr std::array<QuadraturePoint<3>, 8> cube_8 = make_cube_8();

// Triangle: degree 1, 2 [Strang & Fix 1973] and 4 [Dunavant 1985]. A point with barycentric coordinates (1-2a, a, a)
// appears with its permutations.
constexpr std::array<QuadraturePoint<2>, 3> triangle_orbit(double a, double weight) {
  return {{{{a, a}, weight}, {{1 - 2 * a, a}, weight}, {{a, 1 - 2 * a}, weight}}};
}
constexpr std::array<QuadraturePoint<2>, 6> make_triangle_6() {
  const auto p = triangle_orbit(0.44594849091596488632, 0.22338158967801146570 / 2);
  const auto q = triangle_orbit(0.091576213509770743460, 0.10995174365532186764 / 2);
  return {p[0], p[1], p[2], q[0], q[1], q[2]};
}
inline constexpr std::array<QuadraturePoint<2>, 1> triangle_1 = {{{{1.0 / 3, 1.0 / 3}, 0.5}}};
inline constexpr std::array<QuadraturePoint<2>, 3> triangle_3 = triangle_orbit(1.0 / 6, 1.0 / 6);
inline constexpr std::array<QuadraturePoint<2>, 6> triangle_6 = make_triangle_6();

// Tetrahedron: degree 1, 2 with a = (5 - sqrt 5)/20 [Hammer, Marlowe & Stroud 1956], and 5 with 14 points
// [Walkington 2000] (the 11 points of degree 4 have a negative weight).
constexpr std::array<QuadraturePoint<3>, 4> tet_orbit(double a, double weight) {
  const double b = 1 - 3 * a;
  return {{{{a, a, a}, weight}, {{b, a, a}, weight}, {{a, b, a}, weight}, {{a, a, b}, weight}}};
}
constexpr std::array<QuadraturePoint<3>, 14> make_tet_14() {
  const auto p = tet_orbit(0.31088591926330060980, 0.11268792571801585080 / 6);
  const auto q = tet_orbit(0.092735250310891226402, 0.073493043116361949544 / 6);
  const double a = 0.045503704125649649492, b = 0.5 - a, w = 0.042546020777081466438 / 6;
  return {p[0], p[1],           p[2],           p[3],           q[0],           q[1],           q[2],
          q[3], {{a, a, b}, w}, {{a, b, a}, w}, {{b, a, a}, w}, {{b, b, a}, w}, {{b, a, b}, w}, {{a, b, b}, w}};
}
inline constexpr std::array<QuadraturePoint<3>, 1> tet_1 = {{{{0.25, 0.25, 0.25}, 1.0 / 6}}};
inline constexpr std::array<QuadraturePoint<3>, 4> tet_4 = tet_orbit(0.13819660112501051518, 1.0 / 24);
inline constexpr std::array<QuadraturePoint<3>, 14> tet_14 = make_tet_14();

}  // namespace sim
