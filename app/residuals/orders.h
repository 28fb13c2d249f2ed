// How fast the errors of a method fall, from one number of terms to the next.
#pragma once

#include <optional>
#include <vector>

#include "app/residuals/study.h"

namespace app {

struct Orders {
  const Attempt* from = nullptr;
  const Attempt* to = nullptr;
  // Not there where there is no such error, or where it has fallen to round-off.
  std::optional<sim::residual::Real> L2, H1, residual, max;
};

// Of attempts that follow each other with the same basis and method.
std::vector<Orders> orders_of(const ResidualStudy& study);

}  // namespace app
