#include "app/exhibit/print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace app {

std::string printed(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  // "-0.000" is a zero whose sign is round-off.
  std::string result = text;
  if (result.starts_with('-') && result.find_first_of("123456789") == std::string::npos) result.erase(0, 1);
  return result;
}

render::Number number(const std::string& name, const char* format, double value, const std::string& unit) {
  return {name, printed(format, value), unit};
}

render::Matrix matrix(const std::string& label, const std::string& name, const char* format, const Eigen::MatrixXd& A,
                      const std::string& unit) {
  render::Matrix shown{label, static_cast<int>(A.cols()), {}, unit};
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    for (Eigen::Index j = 0; j < A.cols(); ++j)
      shown.entries.push_back(number(name + std::to_string(i + 1) + std::to_string(j + 1), format, A(i, j)));
  return shown;
}

Scaled scaled(double largest, const std::string& unit) {
  static constexpr std::array<const char*, 4> prefixes = {"", "k", "M", "G"};
  int power = largest > 0 ? static_cast<int>(std::floor(std::log10(largest) / 3)) : 0;
  power = std::clamp(power, 0, 3);
  return {std::pow(1000.0, power), prefixes[static_cast<std::size_t>(power)] + unit};
}

}  // namespace app
