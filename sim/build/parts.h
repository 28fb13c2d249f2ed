// All that a built system consists of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/mesh/locate.h"
#include "sim/reduce/reduction.h"
#include "sim/solve/model.h"
#include "sim/time/scheme.h"

namespace sim {

class System;

struct ProbePlace {
  int first_node;  // of its body
  const Mesh* mesh;
  MaterialPoint point;
};

struct Parts {
  Model model;
  const Scheme* scheme = nullptr;
  std::unique_ptr<Reduction> reduction;  // of scenes that move in a basis
  std::vector<ProbePlace> probes;
  std::vector<std::string> remarks;  // on what was settled while building
  std::string no_equilibrium;        // statics: why there is none; empty: there may be one

  // Whose unknowns are stepped.
  const Model& moving() const { return reduction ? reduction->model : model; }
};

const Parts& parts_of(const System& system);

}  // namespace sim
