// What the pages of the lecture show, for their tests.
#pragma once

#include <gtest/gtest.h>

#include "app/options/options.h"
#include "app/picture/frame_history.h"
#include "app/scene/simulation.h"
#include "sim/stepper.h"

namespace app {

inline Options page(const std::filesystem::path& file) {
  Options options;
  options.scene = file;
  options.quiet = true;
  options.width = 320;
  options.height = 180;
  return options;
}

// Keys and values, as --set has them.
using Changes = std::vector<std::pair<std::string, std::string>>;
inline Options changed(Options options, const Changes& changes) {
  for (const auto& [key, value] : changes) options.overrides.push_back({key, value, "--set"});
  return options;
}

// The sheets of the first frames of a page.
inline std::vector<render::Sheet> sheets(const std::filesystem::path& file, int frames, const Changes& changes = {}) {
  const Simulation simulation = build_simulation(changed(page(file), changes));
  FrameHistory history(simulation);
  const auto stepper = sim::make_stepper(*simulation.system, 1);
  sim::State state = simulation.system->initial_state();
  LargestShown largest{};
  std::vector<render::Sheet> all;
  for (int k = 0; k < frames; ++k) {
    history.add(state, largest);
    Moment moment{.frame = k, .state = state};
    history.fill(largest, moment);
    all.push_back(*moment.sheet);
    for (int n = 0; n < simulation.system->steps_per_frame(); ++n) EXPECT_EQ(stepper->step(state).failure, "");
  }
  return all;
}

inline const render::Number& number_named(const render::Sheet& sheet, const std::string& name,
                                          std::vector<render::Number>& all) {
  all = render::numbers_of(sheet);
  const auto found = std::ranges::find(all, name, &render::Number::name);
  if (found == all.end()) throw std::runtime_error("no number " + name);
  return *found;
}
inline std::string text_of(const render::Sheet& sheet, const std::string& name) {
  std::vector<render::Number> all;
  return number_named(sheet, name, all).text;
}

}  // namespace app
