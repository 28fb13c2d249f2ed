// What solvers and steppers share of a built scene: its unknowns, masses and terms of the energy.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "sim/body/body_range.h"
#include "sim/body/mass.h"
#include "sim/body/obstacle_nodes.h"
#include "sim/body/pins.h"
#include "sim/term/contact.h"
#include "sim/term/elastic.h"
#include "sim/term/obstacle.h"
#include "sim/term/term.h"

namespace sim {

// One of the terms that is elastic, and whose it is.
struct ElasticPart {
  const ElasticTerm* term;
  std::size_t number;  // among all terms
  int body;
};

struct Model {
  int D = 3;
  int node_count = 0;  // of bodies, then of obstacles
  int body_nodes = 0;
  int threads = 1;
  Time time;                  // substeps settled
  bool watches_step = false;  // they are what stability needs at rest: explicit schemes watch what it needs later
  Solver solver;
  std::vector<Body> bodies;
  std::vector<BodyRange> ranges;
  std::vector<Obstacle> obstacles;
  std::vector<ObstacleNodes> obstacle_nodes;  // of each
  Eigen::VectorXd X;                          // rest positions, D numbers per node
  Eigen::VectorXd x_start;                    // positions at t = 0
  Eigen::VectorXd node_size;                  // body size [m] at each node
  std::vector<Mass> masses;                   // one for each body
  std::vector<std::unique_ptr<Term>> terms;
  std::vector<ElasticPart> elastic;
  std::vector<const ContactTerm*> contacts;  // of the terms
  std::vector<const ObstacleTerm*> smooth;   // of them: planes and spheres
  std::optional<BlockPattern> pattern;       // only where a solver forms a matrix
  bool dense = false;                        // few unknowns, each of which acts on all others
  Pins pins;
  double energy_scale = 0;  // J: Young's modulus times volume, all bodies; round-off of U is relative to it
  double bound = 0;         // m: a position beyond it has no meaning left, 1e12 sizes of the scene

  Eigen::Index dofs() const { return static_cast<Eigen::Index>(node_count) * D; }
  // Some term is a barrier.
  bool limits_moves() const {
    return std::any_of(terms.begin(), terms.end(), [](const auto& term) { return term->limits_moves(); });
  }
  double smallest_size() const {  // of the bodies, m
    double size = std::numeric_limits<double>::infinity();
    for (const BodyRange& range : ranges) size = std::min(size, range.size);
    return size;
  }
  // Steps are counted in integers, so that frame k is at k/fps exactly.
  double t(std::int64_t step) const {
    return static_cast<double>(step) * time.unit / (static_cast<double>(time.fps) * time.substeps);
  }
  double h() const { return time.unit / (static_cast<double>(time.fps) * time.substeps); }
};

}  // namespace sim
