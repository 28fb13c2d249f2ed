#include "app/colour_values.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace app {
namespace {

// 1, 2 or 5 times a power of ten, at least x > 0.
double round_up(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (x <= step * power * (1 + 1e-9)) return step * power;
  }
  return 10 * power;
}

// What 99 of 100 values do not exceed: a single sharp corner does not decide the colours of the rest.
double nearly_largest(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * last));
  std::ranges::nth_element(values, place);
  return *place;
}

// Stress and energy start at 0; stretch and J lie around 1.
std::array<double, 2> range_of(sim::Quantity quantity, const Eigen::VectorXd& values, double young) {
  std::vector<double> sizes;
  for (const double value : values) {
    const bool around_one = quantity == sim::Quantity::stretch || quantity == sim::Quantity::J;
    sizes.push_back(std::abs(around_one ? value - 1 : value));
  }
  constexpr double strain = 1e-4;   // the smallest that a picture shows
  constexpr double largest = 1e30;  // what a picture's numbers hold, of a body that has exploded
  const double size = std::min(nearly_largest(std::move(sizes)), largest);
  switch (quantity) {
    case sim::Quantity::stress:
      return {0, round_up(std::max(size, young * strain))};
    case sim::Quantity::energy:
      return {0, round_up(std::max(size, young * strain * strain))};
    default: {
      const double reach = round_up(std::max(size, strain));
      return {1 - reach, 1 + reach};
    }
  }
}

// The largest prefix below the value: 2.5e4 Pa is 25 kPa.
std::pair<std::string, double> prefix(double value) {
  if (value >= 1e9) return {"G", 1e-9};
  if (value >= 1e6) return {"M", 1e-6};
  if (value >= 1e3) return {"k", 1e-3};
  return {"", 1};
}

}  // namespace

std::optional<sim::Quantity> quantity(std::string_view colour) {
  if (colour == "stress") return sim::Quantity::stress;
  if (colour == "stretch") return sim::Quantity::stretch;
  if (colour == "energy") return sim::Quantity::energy;
  if (colour == "J") return sim::Quantity::J;
  return std::nullopt;
}

ColourRange colour_range(sim::Quantity quantity, const std::optional<std::array<double, 2>>& range,
                         const Eigen::VectorXd& values, double young) {
  const auto [low, high] = range ? *range : range_of(quantity, values, young);
  ColourRange result;
  const auto [letter, factor] = prefix(std::max(std::abs(low), std::abs(high)));
  switch (quantity) {
    case sim::Quantity::stress:
      result.scale.label = "von Mises stress";
      result.scale.unit = letter + "Pa";
      result.factor = factor;
      break;
    case sim::Quantity::energy:
      result.scale.label = "energy density";
      result.scale.unit = letter + "J/m^3";
      result.factor = factor;
      break;
    case sim::Quantity::stretch:
      result.scale.label = "largest stretch";
      break;
    case sim::Quantity::J:
      result.scale.label = "J = det F";
      break;
  }
  result.scale.low = static_cast<float>(low * result.factor);
  result.scale.high = static_cast<float>(high * result.factor);
  return result;
}

}  // namespace app
