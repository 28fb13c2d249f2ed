// A problem as a TOML file has it: L u = -(k u')' + a u' + q u = f, u(0) = u(1) = 0, and what to try on it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/residual/method.h"
#include "sim/residual/reference.h"

namespace app {

struct ProblemFile {
  std::string name;                                         // the file's stem
  std::map<std::string, std::string, std::less<>> written;  // the expressions of k, a, q, f, exact, as they are given
  sim::residual::Problem problem;                           // `exact` is filled in where it is not given
  sim::residual::Reference reference;                       // the computed solution
  std::vector<const sim::residual::Basis*> bases;
  std::vector<const sim::residual::Method*> methods;
  std::vector<int> n;  // ascending

  bool exact_is_computed() const { return !written.contains("exact"); }
};

constexpr int most_terms = 256;  // of n: matrices are dense

// Throws std::runtime_error with file, line and, in an expression, column.
ProblemFile read_problem(const std::filesystem::path& path);
ProblemFile read_problem(std::string_view text, const std::filesystem::path& path);

}  // namespace app
