#include "render/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace render {

double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  const double lead = length / power * (1 + 1e-9);
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

std::vector<double> ticks(double low, double high, int wanted) {
  if (low > high) std::swap(low, high);
  const double step = (high - low) / std::max(wanted, 1);
  if (!(step > 1e-12 * std::max(std::abs(low), std::abs(high)))) return {low};
  const double round_step = round_length(step);
  std::vector<double> values;
  const double slack = 1e-6 * round_step;
  for (double k = std::ceil((low - slack) / round_step); k * round_step <= high + slack; ++k) {
    values.push_back(k * round_step + 0.0);  // + 0.0: no minus before zero
  }
  return values;
}

double tick_offset(const std::vector<double>& values) {
  constexpr double many = 1e4;  // steps between zero and the values
  if (values.size() < 2) return 0;
  const double step = values[1] - values[0], largest = std::max(std::abs(values.front()), std::abs(values.back()));
  if (largest < many * step) return 0;
  const double power = std::pow(10, std::ceil(std::log10(values.back() - values.front())));
  return std::floor(values.front() / power) * power;
}

std::vector<std::string> tick_labels(const std::vector<double>& values) {
  double largest = 0, step = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (values.size() > 1) step = std::abs(values[1] - values[0]);
  std::array<char, 48> text{};
  std::vector<std::string> labels;
  for (const double value : values) {
    if (step == 0 || largest >= 1e5 || largest < 1e-3) {
      std::snprintf(text.data(), text.size(), "%.3g", value);
    } else {
      const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-6)), 0, 9);
      std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    }
    labels.emplace_back(text.data());
  }
  return labels;
}

std::string power_of_ten(int exponent) {
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

}  // namespace render
