// A box that obstacles meet, and where it is then.
#pragma once

#include <gtest/gtest.h>

#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim::test {

inline double lowest(const State& state, const BodyRange& body, int D) {
  double y = 1e30;
  for (int node = body.first_node; node < body.first_node + body.node_count; ++node)
    y = std::min(y, state.x[static_cast<Eigen::Index>(node) * D + 1]);
  return y;
}
inline double highest(const State& state, const BodyRange& body, int D) {
  double y = -1e30;
  for (int node = body.first_node; node < body.first_node + body.node_count; ++node)
    y = std::max(y, state.x[static_cast<Eigen::Index>(node) * D + 1]);
  return y;
}

inline void steps_without_crossing(const Scene& scene, Stepped& run, int count) {
  for (int k = 0; k < count; ++k) {
    run.steps(1);
    ASSERT_EQ(count_crossings(scene, run.state.x), 0) << "step " << run.state.step;
  }
}

// One box of 1 m, and nothing under it yet.
inline Scene one_box(int cells = 2) {
  Scene scene;
  scene.bodies = {box_body("box", {1, 1, 1}, cells, {0, 0.01, 0})};
  return scene;
}

}  // namespace sim::test
