// The preconditioned conjugate gradient method. [Hestenes & Stiefel 1952]
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace sim {

struct PcgResult {
  int iterations = 0;
  bool converged = false;
  bool positive_definite = true;  // false: a direction of negative curvature was met, x is what was reached before it
};

// Negative curvature at once: there is no direction to use. Later: what was reached is one.
inline bool usable(const PcgResult& result) {
  return result.positive_definite || result.iterations > 1;
}

// In exact arithmetic n iterations solve any system of n unknowns; round-off asks for some more where n is small.
inline int iteration_limit(Eigen::Index n) {
  return 100 + static_cast<int>(std::min<Eigen::Index>(n, 20000));
}

// Vectors that outlive a solve, so that none is allocated in the next.
struct PcgScratch {
  Eigen::VectorXd r, z, p, Ap;
  void resize(Eigen::Index n) {
    for (Eigen::VectorXd* v : {&r, &z, &p, &Ap}) v->resize(n);
  }
};

// Solves A x = b from x = 0 until |b - A x| <= tolerance |b|.
// multiply(p, Ap) gives A p, precondition(r, z) an approximation of A^{-1} r; both symmetric.
template <class Multiply, class Precondition>
PcgResult pcg(const Multiply& multiply, const Precondition& precondition, const Eigen::VectorXd& b, double tolerance,
              int max_iterations, PcgScratch& s, Eigen::VectorXd& x) {
  PcgResult result;
  s.resize(b.size());
  x.setZero();
  s.r = b;
  const double goal = tolerance * tolerance * b.squaredNorm();
  double rr = b.squaredNorm(), rz = 0;
  while (rr > goal) {
    if (result.iterations == max_iterations) return result;
    precondition(s.r, s.z);
    const double rz_new = s.r.dot(s.z);
    if (result.iterations == 0)
      s.p = s.z;
    else
      s.p = s.z + (rz_new / rz) * s.p;
    rz = rz_new;
    multiply(s.p, s.Ap);
    const double pAp = s.p.dot(s.Ap);
    ++result.iterations;
    if (!(pAp > 0)) {
      result.positive_definite = false;
      return result;
    }
    const double a = rz / pAp;
    x += a * s.p;
    s.r -= a * s.Ap;
    rr = s.r.squaredNorm();
    if (!std::isfinite(rr)) return result;
  }
  result.converged = true;
  return result;
}

}  // namespace sim
