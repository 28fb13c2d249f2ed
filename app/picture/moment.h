// A run at the time of a frame: all that its picture may show.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/sheet.h"
#include "sim/report.h"
#include "sim/state.h"

namespace app {

// Energies at the time of a frame [s, J].
struct Energies {
  double t = 0, kinetic = 0, elastic = 0, potential = 0;
};

// By sim::Quantity: reach_of what frames have shown (colour_values.h).
using LargestShown = std::array<double, 5>;

struct Moment {
  std::int64_t frame = 0;
  int newton = 0;  // iterations of the step that led here
  sim::State state = {};
  double min_J = 1;                         // smallest det F after that step
  double largest = 0;                       // value that a frame so far has shown in colour (colour_values.h)
  Eigen::VectorXd full = {};                // m: nodes of bodies in a basis as they are without one; empty: not shown
  std::vector<Energies> energies = {};      // of the frames so far; empty where no picture shows them
  sim::StepReport report = {};              // of that step
  std::optional<render::Sheet> sheet = {};  // what the exhibits show; none where there is none
};

}  // namespace app
