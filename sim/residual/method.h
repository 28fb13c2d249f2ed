// How the coefficients of u = sum c_i u_i are chosen, so that L u = f holds as well as it can.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/residual/problem.h"

namespace sim::residual {

// What a method found.
struct Answer {
  Vector c;
  std::string refusal;  // why there is none; empty: c is the answer
};

struct Method {
  std::string_view name;
  bool needs_curvature;   // of the basis
  bool needs_functional;  // whose minimum is the solution: L must be self-adjoint
  Answer (*solve)(const Problem& problem, const Basis& basis, int n);
};

// A new method is a file and a line there.
std::span<const Method> methods();
// nullptr when the name is not one of a method.
const Method* find_method(std::string_view name);

// Why the basis cannot serve the method; empty where it can.
std::string refusal(const Method& method, const Basis& basis);

// a. Collocation: (L u)(x_j) = f(x_j) at n points of one's own choice, between 0 and 1.
Answer collocate(const Problem& problem, const Basis& basis, const Vector& points);
// Its points i/(n + 1), and the n points of Gauss.
Vector equal_points(int n);
Vector gauss_points(int n);
// b. Least squares: min int (L u - f)^2
Answer least_squares(const Problem& problem, const Basis& basis, int n);
// c. Galerkin: int u_i (L u - f) = 0
Answer galerkin(const Problem& problem, const Basis& basis, int n);
// d. Ritz: min F[u] = int u L u/2 - f u = int k u'^2/2 + a u u'/2 + q u^2/2 - f u. Where L is not self-adjoint, the
// minimum exists all the same, but does not solve L u = f.
Answer ritz(const Problem& problem, const Basis& basis, int n);

}  // namespace sim::residual
