// What a linear solver holds from an earlier solve, and the note of it that State carries: enough to make it again.
#pragma once

#include "sim/solve/tangent_operator.h"
#include "sim/state.h"

namespace sim {

// Notes where A is linearised as the place where `what` was made, now.
void note(const TangentOperator& A, Kept what, KeptFactor& kept);
// Both tell of the same thing, made at the same place.
bool same(const KeptFactor& a, const KeptFactor& b);
// Linearises A where `kept` was made; `scratch` gets the forces.
void return_to(const KeptFactor& kept, TangentOperator& A, Eigen::VectorXd& scratch);

}  // namespace sim
