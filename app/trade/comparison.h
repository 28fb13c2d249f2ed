// What all cases of one trade have in common: the scene, the points and frames that are compared, the screen.
#pragma once

#include <cstdint>

#include "app/scene/simulation.h"
#include "app/trade/case.h"
#include "render/view.h"
#include "sim/study/sample.h"

namespace app {

// Frames stride, 2 stride, ... last are compared.
struct Stretch {
  std::int64_t last = 0, stride = 1;
};

struct Comparison {
  Options options;  // of the scene
  Simulation scene;
  sim::SamplePoints points;
  render::View view;  // at 1080p
  Stretch stretch;

  double seconds() const;  // simulated time that is compared
  bool shortened() const { return stretch.last < scene.last_frame(); }
};

// Throws SceneError; std::runtime_error when the scene has no motion to compare (static).
Comparison make_comparison(const Options& options);

// As many of the first frames as given; of long ones every second, third, ... is compared.
Stretch stretch_of(const Comparison& comparison, std::int64_t frames);

// A case as the comparison's stretch sees it. `scene`: identity of the scene with the case's settings; `threads`: what
// the case runs on.
std::uint64_t case_id(const Comparison& comparison, std::uint64_t scene, int threads);

// The trajectory in pixels: two numbers per point, origin top left.
sim::Trajectory on_screen(const Comparison& comparison, const sim::Trajectory& path);
// The sample points as on_screen needs them: sizes of one pixel.
sim::SamplePoints screen_points(const Comparison& comparison);

}  // namespace app
