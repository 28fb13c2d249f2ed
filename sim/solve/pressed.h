// Who presses whom, where something that is prescribed does not get where it should.
#pragma once

#include <string>

#include "sim/solve/model.h"

namespace sim {

// way: what is left of the ways of prescribed components [m].
std::string pressed_text(const Model& model, const Motion& motion, const Eigen::VectorXd& way);

}  // namespace sim
