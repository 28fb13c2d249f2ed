// Numbers as an exhibit prints them: a fixed count of decimals, so that digits keep their place while they change.
#pragma once

#include <Eigen/Core>
#include <string>

#include "render/sheet.h"

namespace app {

// printf of one number; a zero has no sign.
std::string printed(const char* format, double value);

render::Number number(const std::string& name, const char* format, double value, const std::string& unit = {});

// Entries "NAME11", "NAME12", ..., row by row.
render::Matrix matrix(const std::string& label, const std::string& name, const char* format, const Eigen::MatrixXd& A,
                      const std::string& unit = {});

// The power of 1000 that brings the largest entry to 1 ... 1000, with the unit's prefix: 48439 Pa -> 1e3, "kPa".
struct Scaled {
  double factor;  // unit / printed unit: divide by it
  std::string unit;
};
Scaled scaled(double largest, const std::string& unit);

}  // namespace app
