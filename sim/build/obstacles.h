// The obstacles of a scene: their nodes in the system, and the terms that keep bodies out of them.
//   plane, sphere  barriers on the nodes of bodies: sim/term/obstacle.h
//   surface        contact of its faces with those of every body: sim/term/contact.h
#pragma once

#include <string>

#include "sim/build/parts.h"

namespace sim {

// Its own, or that of its key.
std::string name_of_obstacle(const Model& model, std::size_t k);

// In this order: which nodes obstacles have behind those of bodies; where these are without motion; where motions have
// them at the start.
void number_obstacle_nodes(Model& model);
void place_obstacle_nodes(Model& model);
void move_obstacles_to_start(Model& model);

// Adds a term for each. Throws InputError, for bodies that start inside as well.
void add_obstacles(Parts& parts);

}  // namespace sim
