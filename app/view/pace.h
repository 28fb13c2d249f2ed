// Keeps simulated time to the wall clock where it can, and tells how far it falls behind where it cannot. Decides when
// steps are taken, never what they do.
#pragma once

namespace app {

class Pace {
 public:
  // `wall` seconds have passed; steps are `h` seconds long.
  void pass(double wall, double h);
  // True when a step is due.
  bool due(double h) const { return debt_ >= h; }
  void stepped(double h);
  // After a pause: nothing is owed.
  void restart();

  // Simulated over wall time of about the last second; 1 where it keeps up.
  double factor() const { return factor_; }

 private:
  double debt_ = 0;                  // s that simulated time is behind
  double wall_ = 0, simulated_ = 0;  // s since the factor was measured
  double factor_ = 1;
};

}  // namespace app
