// Is a deformed mesh folded through itself? The map is locally one to one where no element is inverted and every
// interior edge (in the plane: node) is wound once by the elements around it: their signed angles at it add up to 2 pi,
// as at rest. In any other state the sum is another multiple of 2 pi.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/mesh/components.h"

namespace sim {

class Tangle {
 public:
  // Of one connected part; node numbers are shifted by first_node in vectors with D numbers per node. Middle nodes are
  // not looked at. Of membranes there is nothing to tell.
  Tangle(const Mesh& mesh, const Component& part, int first_node, int D);

  struct Count {
    int inverted = 0;  // elements that are turned inside out at a corner
    int wound = 0;     // interior edges or nodes
    bool any() const { return inverted > 0 || wound > 0; }
  };
  Count count(const Eigen::VectorXd& x) const;

 private:
  // An element's angle at the edge from a to b, between its other edges at a, to p and to q; positive at rest.
  // In the plane b is not used: the angle is at a, about z.
  struct Wedge {
    int a, b, p, q;
  };
  double angle(const Eigen::VectorXd& x, const Wedge& wedge) const;
  double volume(const Eigen::VectorXd& x, const Wedge& wedge) const;
  Eigen::Vector3d at(const Eigen::VectorXd& x, int node) const;

  int D_;
  std::vector<Wedge> corners_;           // one for each corner of each element: its volume tells of inversion
  std::vector<int> corners_of_element_;  // how many, element by element
  std::vector<Wedge> wedges_;            // around interior edges or nodes, one after the other
  std::vector<int> start_;               // of each of these, and the end
};

}  // namespace sim
