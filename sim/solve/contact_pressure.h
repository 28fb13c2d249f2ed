// What contacts and obstacles press on the surfaces of bodies, for the eye.
#pragma once

#include "sim/solve/model.h"

namespace sim {

// For each node of the system, the normal force on it over the surface that is its share [Pa]; 0 inside.
Eigen::VectorXd contact_pressure(const Model& model, const Motion& motion);

}  // namespace sim
