// The values that colour a body, and the scale that they are shown on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "app/scene/look.h"
#include "render/frame.h"
#include "sim/system.h"

namespace app {

// What look.colour names; none for "plain".
std::optional<sim::Quantity> quantity(std::string_view colour);

// How far values reach from 0, or from 1 for stretch and J [SI]: what 99 of 100 do not exceed, so that a single sharp
// corner does not decide the colours of the rest.
double reach_of(sim::Quantity quantity, const Eigen::VectorXd& values);

// How far they will reach as far as a scene tells before a step is taken, from weight, loads, motion of pins and
// speeds; often too little, at least what is more than rounding errors.
double expected_reach(sim::Quantity quantity, const sim::Scene& scene);

// Values [SI] times `factor` are what the scale shows: kPa, say, where the values are large in Pa.
struct ColourRange {
  render::ColourScale scale;
  double factor = 1;
};

// The look's own range, or round numbers around what is expected and what has been reached so far: it grows in steps of
// a third or so and never shrinks, and a run that was resumed goes on with the same.
ColourRange colour_range(sim::Quantity quantity, const Look& look, double reach);

}  // namespace app
