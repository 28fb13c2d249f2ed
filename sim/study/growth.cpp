#include "sim/study/growth.h"

#include <algorithm>
#include <cmath>

#include "sim/body/random.h"
#include "sim/stepper.h"

namespace sim {

namespace {

// h as a whole number of units over a whole number of frames, to a millionth.
void set_time_step(Time& time, double h) {
  time.unit = std::max(1, static_cast<int>(std::ceil(1e6 * h)));
  time.fps = static_cast<int>(std::lround(time.unit / h));
  time.substeps = 1;
}

}  // namespace

double Growth::per_step() const {
  constexpr double small = 1e-3;  // m
  const auto grown = std::find_if(reach.begin(), reach.end(), [](double r) { return r > small; });
  const auto steps = [](auto from, auto to) { return 1.0 / static_cast<double>(to - from); };
  if (grown == reach.end()) {
    const auto half = reach.begin() + static_cast<std::ptrdiff_t>(reach.size() / 2);
    const double before = *std::max_element(reach.begin(), half), after = *std::max_element(half, reach.end());
    return std::pow(after / before, steps(reach.begin(), half));
  }
  const auto last = grown - 1, first = last - std::min<std::ptrdiff_t>(30, (last - reach.begin()) / 2);
  return last > first ? std::pow(*last / *first, steps(first, last)) : *grown / small;
}

Growth growth(const Scene& scene, const std::string& integrator, double h, int steps) {
  Scene resting = scene;
  resting.time.integrator = integrator;
  set_time_step(resting.time, h);
  resting.world.gravity.setZero();
  for (Body& body : resting.bodies) body.start = {};
  const System system(resting);
  const auto stepper = make_stepper(system, 1);
  State state = system.initial_state();
  const Eigen::VectorXd rest = state.x;
  double size = 0;
  for (const BodyRange& range : system.bodies()) size = std::max(size, range.size);
  Random random(scene.seed);
  for (double& v : state.v) v = random.uniform(-1, 1) < 0 ? -1e-12 * size / h : 1e-12 * size / h;
  Growth grown{{0}, {rest}};
  for (int k = 0; k < steps; ++k) {
    if (!stepper->step(state).failure.empty()) break;
    grown.reach.push_back((state.x - rest).cwiseAbs().maxCoeff());
    grown.x.push_back(state.x);
  }
  return grown;
}

// u_{n+1} - 2u_n + u_{n-1} = -4 x^2 u_n has the roots -(x -+ sqrt(x^2 - 1))^2; up to x = 1 both are of size 1.
double growth_per_step(double x) {
  if (x <= 1) return 1;
  const double root = x + std::sqrt(x * x - 1);
  return root * root;
}

}  // namespace sim
