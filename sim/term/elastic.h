// The elastic energy of one region of a body: U = sum_e sum_q w_q Psi(F_q), F = x_e G. [mathematics.md 2]
#pragma once

#include <cstdint>

#include "sim/mesh/input_error.h"
#include "sim/scene.h"
#include "sim/term/term.h"

namespace sim {

// What the elastic terms of all elements and materials have in common.
class ElasticTerm : public Term {
 public:
  Role role() const final { return Role::elastic; }
  // Smallest J over the quadrature points and the element (number in the body's mesh) where it is.
  // A membrane's J is its area ratio, never negative.
  struct SmallestJ {
    double J;
    int element;
    int inverted = 0;  // elements with J <= 0
  };
  virtual SmallestJ smallest_J(const Eigen::VectorXd& x, Store& store) const = 0;
  // For the node values of a quantity: at each node of an element sums += w value, weights += w (numbers of the
  // system).
  virtual void add_node_values(const Eigen::VectorXd& x, Quantity quantity, Eigen::VectorXd& sums,
                               Eigen::VectorXd& weights) const = 0;
  // Rest volume [m^3].
  virtual double volume() const = 0;
  // Memory of the element data and of one linearisation.
  virtual std::int64_t bytes() const = 0;
};

// What an elastic term is made from.
struct ElasticInput {
  const Body& body;
  const MaterialSpec& material;
  std::vector<int> elements;        // numbers in the body's mesh, in the order of the batches
  int first_node;                   // of the body in the system
  int node_count;                   // of the system
  std::vector<double> counts = {};  // how often each of them counts; empty: once
};

// D = 2 in a plane scene, 3 otherwise. Throws InputError for an unknown material (key "model") or an element that
// cannot be in space (key "mesh").
std::unique_ptr<ElasticTerm> make_elastic(const ElasticInput& input, int D);

// One for each element and D, each in a file of its own so that they compile side by side: elastic_tet4.cpp ...
template <class Element, int D>
std::unique_ptr<ElasticTerm> make_elastic_of(const ElasticInput& input);

}  // namespace sim
