// What terms, solvers and steppers share of a built system.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sim/mass.h"
#include "sim/mesh/locate.h"
#include "sim/pins.h"
#include "sim/system.h"
#include "sim/term/elastic.h"
#include "sim/term/term.h"
#include "sim/time/scheme.h"

namespace sim {

struct ProbePlace {
  int first_node;  // of its body
  const Mesh* mesh;
  MaterialPoint point;
};

struct System::Parts {
  int D = 3;
  int node_count = 0;
  int threads = 1;
  Time time;  // substeps settled
  Solver solver;
  std::uint64_t seed = 1;
  const Scheme* scheme = nullptr;
  std::vector<Body> bodies;
  std::vector<BodyRange> ranges;
  Eigen::VectorXd X;          // rest positions, D numbers per node
  Eigen::VectorXd x_start;    // positions at t = 0
  Eigen::VectorXd node_size;  // body size [m] at each node
  std::vector<Mass> masses;   // one for each body
  std::vector<std::unique_ptr<Term>> terms;
  std::vector<const ElasticTerm*> elastic;  // those of the terms that are
  std::vector<int> elastic_body;            // and the body of each
  std::optional<BlockPattern> pattern;      // only where a solver forms a matrix
  Pins pins;
  std::vector<ProbePlace> probes;
  double energy_scale = 0;  // J: Young's modulus times volume, all bodies; round-off of U is relative to it
  double bound = 0;         // m: a position beyond it has no meaning left, 1e12 sizes of the scene
  std::vector<std::string> remarks;

  Eigen::Index dofs() const { return static_cast<Eigen::Index>(node_count) * D; }
  // Steps are counted in integers, so that frame k is at k/fps exactly.
  double t(std::int64_t step) const {
    return static_cast<double>(step) * time.unit / (static_cast<double>(time.fps) * time.substeps);
  }
  double h() const { return time.unit / (static_cast<double>(time.fps) * time.substeps); }
};

}  // namespace sim
