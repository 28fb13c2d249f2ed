#include "sim/body/pins.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>

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
      const Vec3 position = pose.place(rest_of(pin, i)), velocity = pose.velocity(position);
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

Vec3 Pins::rest_of(const Held& pin, std::size_t i) const {
  Vec3 X = Vec3::Zero();
  X.head(D_) = pin.rest.segment(i * D_, D_);
  return X;
}

std::optional<Pins::Disagreement> Pins::clash_at(double t, const Eigen::VectorXd& node_size,
                                                 const std::vector<int>& shared) const {
  constexpr double rounding = 1e-9;  // of the body's size
  struct Wanted {
    const Held* by;
    double position;
  };
  std::map<Eigen::Index, Wanted> wanted;  // by component
  std::optional<Disagreement> worst;
  for (const Held& pin : pins_) {
    if (t > pin.release) continue;
    const Pose pose(pin.motion, t);
    for (std::size_t i = 0; i < pin.nodes.size(); ++i) {
      if (!std::binary_search(shared.begin(), shared.end(), pin.nodes[i])) continue;
      const Vec3 position = pose.place(rest_of(pin, i));
      for (const int c : pin.axes) {
        const auto [other, is_first] =
            wanted.try_emplace(Eigen::Index{pin.nodes[i]} * D_ + c, Wanted{&pin, position[c]});
        const double apart = std::abs(other->second.position - position[c]);
        if (is_first || apart <= std::max(rounding * node_size[pin.nodes[i]], worst ? worst->distance : 0)) continue;
        worst = {other->second.by->name, pin.name, t, apart};
      }
    }
  }
  return worst;
}

// Of several pins, before `end`, in rising order.
std::vector<int> Pins::shared_nodes(int end) const {
  std::vector<int> all, shared;
  for (const Held& pin : pins_)
    std::copy_if(pin.nodes.begin(), pin.nodes.end(), std::back_inserter(all), [&](int node) { return node < end; });
  std::sort(all.begin(), all.end());
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i] == all[i - 1]) shared.push_back(all[i]);
  return shared;
}

std::optional<Pins::Disagreement> Pins::clash(const Eigen::VectorXd& node_size, int end) const {
  const std::vector<int> shared = shared_nodes(end);
  if (shared.empty()) return std::nullopt;
  std::set<double> times = {0};
  for (const Held& pin : pins_)
    for (const Keyframe& keyframe : pin.motion) times.insert(keyframe.t);
  for (const double t : times)
    if (auto found = clash_at(t, node_size, shared)) return found;
  return std::nullopt;
}

Pins::Disagreement Pins::first_jump(int end) const {
  Disagreement furthest;
  for (const Held& pin : pins_) {
    const Pose pose(pin.motion, 0);
    for (std::size_t i = 0; i < pin.nodes.size(); ++i) {
      const Vec3 rest = rest_of(pin, i);
      const double distance = (pose.place(rest) - rest).norm();
      if (pin.nodes[i] < end && distance > furthest.distance) furthest = {pin.name, pin.name, 0, distance};
    }
  }
  return furthest;
}

}  // namespace sim
