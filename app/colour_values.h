// The values that colour a body, and the scale that they are shown on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "render/frame.h"
#include "sim/system.h"

namespace app {

// What look.colour names; none for "plain".
std::optional<sim::Quantity> quantity(std::string_view colour);

// Values [SI] times `factor` are what the scale shows: kPa, say, where the values are large in Pa.
struct ColourRange {
  render::ColourScale scale;
  double factor = 1;
};

// `range`: SI values at the ends; none: round numbers that hold nearly all values. `young` [Pa]: of the softest body,
// for the smallest range that is more than rounding errors.
ColourRange colour_range(sim::Quantity quantity, const std::optional<std::array<double, 2>>& range,
                         const Eigen::VectorXd& values, double young);

}  // namespace app
