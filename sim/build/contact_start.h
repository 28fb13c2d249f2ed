// Whether bodies that may touch start apart.
#pragma once

#include <string>

#include "sim/contact/start_error.h"
#include "sim/solve/model.h"

namespace sim {

// Bodies that cross, or touch, at the start could only be forced apart. Throws StartError with this key; x: where the
// nodes start.
void check_contact_start(const Model& model, const ContactTerm& term, const Eigen::VectorXd& x, const std::string& key);

}  // namespace sim
