#include "app/view/pace.h"

#include <algorithm>

namespace app {

void Pace::pass(double wall, double h) {
  // What cannot be caught up within a tenth of a second is given up.
  debt_ = std::min(debt_ + wall, std::max(h, 0.1));
  wall_ += wall;
  if (wall_ < 1) return;
  factor_ = std::min(1.0, (simulated_ + h) / wall_);
  wall_ = simulated_ = 0;
}

void Pace::stepped(double h) {
  debt_ -= h;
  simulated_ += h;
}

void Pace::restart() {
  debt_ = wall_ = simulated_ = 0;
  factor_ = 1;
}

}  // namespace app
