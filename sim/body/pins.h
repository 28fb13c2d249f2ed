// Prescribed positions: which components of which nodes follow a script, and where it puts them.
#pragma once

#include <Eigen/Core>
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

 private:
  struct Held {
    std::vector<int> nodes;
    Eigen::VectorXd rest;   // D numbers per node
    std::vector<int> axes;  // components prescribed
    std::vector<Keyframe> motion;
    double release;  // s; infinity: never
    Name name;
  };
  int D_ = 3;
  std::vector<Held> pins_;
};

}  // namespace sim
