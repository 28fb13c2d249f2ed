// A system that moves in a basis, x = X + U c: its energy as a function of c alone is a system of its own, with a unit
// mass for each coordinate, as U^T M U = 1:
//   T = 1/2 dc/dt . dc/dt,   U(c) = U(X + U c)
// Schemes, Newton's method and its line search then work on c as they do on nodes.
#pragma once

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

#include "sim/reduce/lift.h"
#include "sim/solve/model.h"
#include "sim/state.h"
#include "sim/term/elastic.h"

namespace sim {

// The elements of all bodies that stand for all others, each with nodes of its own.
struct Sample {
  std::vector<std::unique_ptr<Body>> bodies;  // that the terms are made from
  std::unique_ptr<Lift> lift;
  std::vector<std::unique_ptr<ElasticTerm>> elastic;
  std::vector<int> body;               // of each of these terms
  std::vector<std::vector<int>> from;  // of each body: the numbers that its elements have in the whole mesh
};

struct Reduction {
  std::unique_ptr<Lift> lift;                // of all nodes
  Lift::Rows mass;                           // M U
  Eigen::LLT<Eigen::MatrixXd> gram;          // U^T M U, which is 1 to round-off where masses are those of the basis
  std::optional<Sample> sample;              // with a cubature
  std::vector<std::unique_ptr<Lift>> lifts;  // of the few nodes that springs have, say
  std::vector<std::unique_ptr<Term>> terms;  // that the model's refer to
  std::unique_ptr<Mass> massless;            // for terms that ask for a mass and have none
  Model model;                               // of the coordinates

  // c of the positions x that are nearest in the mass norm, (U^T M U) c = U^T M (x - X); rate of velocities v.
  Eigen::VectorXd coordinates_of(const Eigen::VectorXd& x) const;
  Eigen::VectorXd rate_of(const Eigen::VectorXd& v) const;
  // Takes a state whose coordinates are missing into the basis.
  void enter(State& state) const;
};

}  // namespace sim
