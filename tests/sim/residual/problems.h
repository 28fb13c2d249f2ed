// The problems of tests/data/lecture, and its tables.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "sim/residual/jet.h"
#include "sim/residual/problem.h"

namespace sim::test {

using residual::Jet;
using residual::Real;

inline residual::Function constant(Real value) {
  return [value](Real) { return Jet{value, 0}; };
}

// -u'' = pi^2 sin(pi x) + e^x
inline residual::Problem problem_a() {
  const Real pi = std::numbers::pi_v<Real>, e = std::numbers::e_v<Real>;
  return {constant(1), constant(0), constant(0),
          [pi](Real x) {
            const Jet t{x, 1};
            return Jet{pi * pi, 0} * sin(Jet{pi, 0} * t) + exp(t);
          },
          [pi, e](Real x) {
            const Jet t{x, 1};
            return sin(Jet{pi, 0} * t) - exp(t) + Jet{1 + (e - 1) * x, e - 1};
          }};
}

// -((1 + x) u')' + u = e^x (-1 + 5x + 4x^2 + x^3)
inline residual::Problem problem_b() {
  return {[](Real x) {
            return Jet{1 + x, 1};
          },
          constant(0), constant(1),
          [](Real x) {
            return exp(Jet{x, 1}) * Jet{-1 + 5 * x + 4 * x * x + x * x * x, 5 + 8 * x + 3 * x * x};
          },
          [](Real x) {
            return exp(Jet{x, 1}) * Jet{x - x * x, 1 - 2 * x};
          }};
}

// -eps u'' + u' = 1
inline residual::Problem problem_c(Real eps) {
  return {constant(eps), constant(1), constant(0), constant(1), [eps](Real x) {
            const Real layer = std::exp((x - 1) / eps), left = std::exp(-1 / eps);
            return Jet{x - (layer - left) / (1 - left), 1 - layer / eps / (1 - left)};
          }};
}

inline residual::Problem problem_named(const std::string& name) {
  return name == "A" ? problem_a() : name == "B" ? problem_b() : problem_c(name == "C0.1" ? 0.1L : 0.01L);
}

// The rows of a table without its header, cut at the commas.
inline std::vector<std::vector<std::string>> rows_of(const std::string& name) {
  std::ifstream file(std::string(RITZ_SOURCE_DIR) + "/tests/data/lecture/" + name);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    if (line.ends_with('\r')) line.pop_back();
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

}  // namespace sim::test
