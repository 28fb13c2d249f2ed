#include "sim/body/pins.h"

#include <Eigen/Geometry>
#include <limits>

namespace sim {

namespace {

// x(t) = c + R(theta) (X - c) + translate, and its derivative along the script.
struct Pose {
  Keyframe at;  // pose now
  Vec3 translate_rate = {0, 0, 0};
  double degrees_rate = 0;

  // Linear between keyframes, constant outside; at a keyframe the rate is that of the piece before it.
  Pose(const std::vector<Keyframe>& motion, double t) {
    if (motion.empty()) return;
    std::size_t k = 0;
    while (k < motion.size() && motion[k].t < t) ++k;
    at = motion[k == motion.size() ? k - 1 : k];
    if (k == 0 || k == motion.size()) return;
    const Keyframe &from = motion[k - 1], &to = motion[k];
    const double span = to.t - from.t, s = (t - from.t) / span;
    at.translate = (1 - s) * from.translate + s * to.translate;
    at.degrees = (1 - s) * from.degrees + s * to.degrees;
    translate_rate = (to.translate - from.translate) / span;
    degrees_rate = (to.degrees - from.degrees) / span;
  }

  void apply(const Vec3& X, Vec3& x, Vec3& v) const {
    constexpr double radians = 3.14159265358979323846 / 180;
    const Vec3 arm = Eigen::AngleAxisd(at.degrees * radians, at.axis.normalized()) * (X - at.centre);
    x = at.centre + arm + at.translate;
    v = degrees_rate * radians * at.axis.normalized().cross(arm) + translate_rate;
  }
};

}  // namespace

void Pins::add(const Pin& pin, const std::vector<int>& nodes, const Eigen::VectorXd& X, int D) {
  D_ = D;
  Held held{nodes,
            Eigen::VectorXd(nodes.size() * D),
            {},
            pin.motion,
            pin.release.value_or(std::numeric_limits<double>::infinity())};
  for (std::size_t i = 0; i < nodes.size(); ++i) held.rest.segment(i * D, D) = X.segment(nodes[i] * D, D);
  for (int c = 0; c < D; ++c)
    if (pin.axes.find("xyz"[c]) != std::string::npos) held.axes.push_back(c);
  pins_.push_back(std::move(held));
}

int Pins::released(double t) const {
  int count = 0;
  for (const Held& pin : pins_) count += t > pin.release;
  return count;
}

void Pins::mark(double t, Eigen::VectorXd& free) const {
  free.setOnes();
  for (const Held& pin : pins_)
    if (t <= pin.release)
      for (const int node : pin.nodes)
        for (const int c : pin.axes) free[node * D_ + c] = 0;
}

void Pins::prescribe(double t, Eigen::VectorXd& x, Eigen::VectorXd& v) const {
  for (const Held& pin : pins_) {
    if (t > pin.release) continue;
    const Pose pose(pin.motion, t);
    for (std::size_t i = 0; i < pin.nodes.size(); ++i) {
      Vec3 X = Vec3::Zero(), position, velocity;
      X.head(D_) = pin.rest.segment(i * D_, D_);
      pose.apply(X, position, velocity);
      for (const int c : pin.axes) {
        x[pin.nodes[i] * D_ + c] = position[c];
        v[pin.nodes[i] * D_ + c] = velocity[c];
      }
    }
  }
}

std::vector<int> Pins::nodes(double t) const {
  std::vector<int> all;
  for (const Held& pin : pins_)
    if (t <= pin.release) all.insert(all.end(), pin.nodes.begin(), pin.nodes.end());
  return all;
}

}  // namespace sim
