// Prescribed positions: which components of which nodes follow a script, and where it puts them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene.h"

namespace sim {

class Pins {
 public:
  // For messages: what prescribes ("pin 0 of \"bear\""), and the body or obstacle that it moves.
  struct Name {
    std::string text, owner;
  };
  // Adds the pin's nodes (numbers of the system). D numbers per node; X: the positions that its script moves, of the
  // system.
  void add(const Pin& pin, const std::vector<int>& nodes, const Eigen::VectorXd& X, int D, const Name& name);

  bool empty() const { return pins_.empty(); }
  // Number of pins that are released at time t or before: while it is the same, so are the free components.
  int released(double t) const;
  // free[i] = 0 where component i is prescribed at time t, else 1.
  void mark(double t, Eigen::VectorXd& free) const;
  // Writes prescribed positions and velocities of time t; other components stay.
  void prescribe(double t, Eigen::VectorXd& x, Eigen::VectorXd& v) const;
  std::vector<int> nodes(double t) const;
  // Of the pin that prescribes the node at time t.
  Name name_of(int node, double t) const;

  // What two pins of bodies want of the same node, or one that begins elsewhere than at rest.
  struct Disagreement {
    Name first, second;
    double t = 0, distance = 0;  // s, m
  };
  // The first time among those of the keyframes when two pins want a node, of those before `end`, in places further
  // apart than rounding leaves them; the one that was added later has its way. node_size: body size [m] at each node.
  std::optional<Disagreement> clash(const Eigen::VectorXd& node_size, int end) const;
  // Of the pins of nodes before `end`, the one whose script carries its nodes furthest from rest at t = 0.
  Disagreement first_jump(int end) const;

 private:
  struct Held {
    std::vector<int> nodes;
    Eigen::VectorXd rest;   // D numbers per node
    std::vector<int> axes;  // components prescribed
    std::vector<Keyframe> motion;
    double release;  // s; infinity: never
    Name name;
  };
  Vec3 rest_of(const Held& pin, std::size_t i) const;
  std::vector<int> shared_nodes(int end) const;
  std::optional<Disagreement> clash_at(double t, const Eigen::VectorXd& node_size,
                                       const std::vector<int>& shared) const;

  int D_ = 3;
  std::vector<Held> pins_;
};

}  // namespace sim
