#include "app/picture/colour_values.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/element/element.h"

namespace app {
namespace {

// 1, 1.5, 2, 3, 4, 6 or 8 times a power of ten, at least x > 0.
double round_up(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0}) {
    if (x <= step * power * (1 + 1e-9)) return step * power;
  }
  return 10 * power;
}

bool around_one(sim::Quantity quantity) {
  return quantity == sim::Quantity::stretch || quantity == sim::Quantity::J;
}

// Stress and energy start at 0; stretch and J lie around 1.
std::array<double, 2> range_of(sim::Quantity quantity, double reach) {
  const double size = round_up(reach);
  if (around_one(quantity)) return {1 - size, 1 + size};
  return {0, size};
}

// The strain of a body of length L that its weight, its loads, its pins and its speed cause, roughly:
// rho g L/E, |traction|/E, p/E, of a membrane p L/(2 t E), way/L, v sqrt(rho/E).
double expected_strain(const sim::Scene& scene, const sim::Body& body, const sim::MaterialSpec& material) {
  const double length = (body.mesh.X.rowwise().maxCoeff() - body.mesh.X.rowwise().minCoeff()).maxCoeff();
  double strain = material.density * scene.world.gravity.norm() * length / material.young;
  for (const sim::Traction& load : body.loads.tractions) strain = std::max(strain, load.value.norm() / material.young);
  const double bearing = sim::info(body.mesh.kind).dimension < scene.dimension ? length / (2 * body.thickness) : 1;
  for (const sim::Pressure& load : body.loads.pressures)
    strain = std::max(strain, std::abs(load.value) * bearing / material.young);
  for (const sim::Pin& pin : body.pins) {
    for (const sim::Keyframe& pose : pin.motion) {
      strain = std::max({strain, pose.translate.norm() / length, std::abs(pose.degrees) / 180});
    }
  }
  const double speed = std::max(body.velocity.norm(), std::abs(body.spin.rate) * length);
  return std::max(strain, speed * std::sqrt(material.density / material.young));
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
  if (colour == "pressure") return sim::Quantity::pressure;
  return std::nullopt;
}

double reach_of(sim::Quantity quantity, const Eigen::VectorXd& values) {
  std::vector<double> sizes;
  for (const double value : values) {
    // Most of a body is pressed by nothing.
    if (quantity == sim::Quantity::pressure && value == 0) continue;
    sizes.push_back(std::abs(around_one(quantity) ? value - 1 : value));
  }
  if (sizes.empty()) return 0;
  const auto last = static_cast<double>(sizes.size() - 1);
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * last));
  std::ranges::nth_element(sizes, place);
  constexpr double largest = 1e30;  // what a picture's numbers hold, of a body that has exploded
  return std::min(*place, largest);
}

double expected_reach(sim::Quantity quantity, const sim::Scene& scene) {
  constexpr double least = 1e-4, most = 0.5;  // strains that a picture shows, and that a guess is good for
  double reach = 0;
  for (const sim::Body& body : scene.bodies) {
    for (const sim::MaterialSpec& material : body.materials) {
      const double strain = std::clamp(expected_strain(scene, body, material), least, most);
      switch (quantity) {
        case sim::Quantity::stress:
        case sim::Quantity::pressure:
          reach = std::max(reach, material.young * strain);
          break;
        case sim::Quantity::energy:
          reach = std::max(reach, material.young * strain * strain / 2);
          break;
        default:
          reach = std::max(reach, strain);
      }
    }
  }
  return reach;
}

ColourRange colour_range(sim::Quantity quantity, const Look& look, double reach) {
  const auto [low, high] = look.range ? *look.range : range_of(quantity, reach);
  ColourRange result;
  result.scale.map = look.colour_map.value_or(around_one(quantity) ? "blue-red" : "viridis");
  const auto [letter, factor] = prefix(std::max(std::abs(low), std::abs(high)));
  switch (quantity) {
    case sim::Quantity::stress:
      result.scale.label = "von Mises stress";
      result.scale.unit = letter + "Pa";
      result.factor = factor;
      break;
    case sim::Quantity::pressure:
      result.scale.label = "contact pressure";
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
