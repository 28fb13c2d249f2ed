// A problem solved in every basis by every method with every number of terms.
#pragma once

#include <string>
#include <vector>

#include "app/residuals/problem_file.h"
#include "sim/residual/errors.h"

namespace app {

struct Attempt {
  std::string method;  // "ritz-anyway" where it does not apply
  sim::residual::Trial u;
  sim::residual::Errors errors;

  std::string_view basis() const { return u.basis().name; }
  int n() const { return static_cast<int>(u.coefficients().size()); }
};

struct ResidualStudy {
  ProblemFile file;
  sim::residual::Asymmetry asymmetry;
  std::vector<Attempt> attempts;      // of those that could be solved, n running fastest
  std::vector<std::string> refusals;  // of the others, each once
};

// With `anyway`, Ritz's method is used where L is not self-adjoint.
ResidualStudy study_residuals(ProblemFile file, bool anyway);

}  // namespace app
