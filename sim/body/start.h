// Where a body starts that does not start at rest: extremes to recover from, and starts that a scene gives, as a table
// of functions on X.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string_view>

#include "sim/mesh/input_error.h"
#include "sim/scene.h"

namespace sim {

struct StartMaking;

struct StartShape {
  std::string_view name;
  double amount;           // default of Start::amount
  double perturbation;     // default of Start::perturbation
  std::string_view along;  // default of Start::direction: the "longest" or "thinnest" axis at rest; empty: it has none
  std::string_view what;   // in a few words, with the meaning of the amount
  void (*make)(StartMaking&);
  bool given = false;  // by further values of Start, without which there is none; not one of the extremes
};

std::span<const StartShape> start_shapes();
// nullptr when there is none of that name.
const StartShape* find_start_shape(std::string_view name);

// Node positions at the start, dimension of space x nodes; `seed` settles everything random. The mesh may have fewer
// dimensions (a plane mesh in space has z = 0). Throws InputError (key "start.shape") for an unknown name.
Eigen::MatrixXd start_positions(const Mesh& mesh, const Start& start, int D, std::uint64_t seed);

}  // namespace sim
