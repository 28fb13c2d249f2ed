// How much too stiff elements of a kind are when a block of them is bent: a measurement, not a list of names.
#pragma once

#include <array>

#include "sim/element/kind.h"
#include "sim/math/vec3.h"

namespace sim {

// A block of cells; in the plane the third number of both counts for nothing.
struct BentBlock {
  Vec3 lengths = {1, 1, 1};  // m
  std::array<int, 3> cells = {2, 2, 2};
  bool confined = false;  // all of its surface is moved as the continuum would be, not the ends alone
};

// The end faces x = 0 and x = length turn against each other about z while all else is free: pure bending. The energy
// of the elements over that of the continuum, minus 1, for a linear material with this Poisson's ratio; 0: exact.
double bending_excess(ElementKind kind, const BentBlock& block, double poisson);

}  // namespace sim
