// Finds what errors are measured against on the scene's mesh.
#pragma once

#include <functional>

#include "app/trade/measurement.h"

namespace app {

// With `fine` steps a frame, fewer where those do not fit into the time. Returns how many, 0 when there is no
// reference: then no error is known, and a note says why.
int find_reference(Measurement& m, int fine);

// Makes the coarsest reference, so that there is one whatever takes the time after it.
void prepare_reference(Measurement& m);

// Just fine enough: with more and more steps, until its uncertainty is what `wanted` then says, or the time does not
// allow more. Errors of the goal. False: none.
bool refine_reference(Measurement& m, const std::function<double()>& wanted);

// Steps a frame that bring an uncertainty, found with `fine` of them, below what is wanted: a power of two times as
// many, as halving steps quarters what is left of second order.
int fine_enough(int fine, double uncertainty, double wanted);

}  // namespace app
