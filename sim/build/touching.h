// Bodies that start on an obstacle, and those that start inside it.
#pragma once

#include <string>
#include <vector>

#include "sim/solve/model.h"
#include "sim/term/obstacle.h"

namespace sim {

// For every node: whether a pin holds all its components for good. No obstacle can move it.
std::vector<char> still_nodes(const Model& model);

// A body that touches the obstacle starts `gap` [m] above it, as the barrier is infinite on the surface itself. Throws
// InputError with this key for one that is deeper in, with the translation that frees it.
void part_from_obstacle(const ObstacleTerm& obstacle, const std::string& key, const BodyRange& body, double gap,
                        Model& model);

// Throws InputError with this key where an obstacle begins within a body: it touches nothing there, and could not come
// out. `point` [m] is on it or in it.
void check_outside(const Model& model, const Vec3& point, const std::string& key);

}  // namespace sim
