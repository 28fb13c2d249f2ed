#include "sim/body/pins.h"

#include <algorithm>
#include <limits>

#include "sim/body/pose.h"

namespace sim {

void Pins::add(const Pin& pin, const std::vector<int>& nodes, const Eigen::VectorXd& X, int D, const Name& name) {
  D_ = D;
  Held held{nodes,
            Eigen::VectorXd(nodes.size() * D),
            {},
            pin.motion,
            pin.release.value_or(std::numeric_limits<double>::infinity()),
            name};
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
      Vec3 X = Vec3::Zero();
      X.head(D_) = pin.rest.segment(i * D_, D_);
      const Vec3 position = pose.place(X), velocity = pose.velocity(position);
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

Pins::Name Pins::name_of(int node, double t) const {
  for (const Held& pin : pins_)
    if (t <= pin.release && std::find(pin.nodes.begin(), pin.nodes.end(), node) != pin.nodes.end()) return pin.name;
  return {};
}

}  // namespace sim
