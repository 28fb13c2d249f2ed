// Makes the stepper of a system.
#pragma once

#include <functional>
#include <memory>

#include "sim/system.h"
#include "sim/time/stepper.h"

namespace sim {

// The stepper that the scene's integrator and solver name. `system` must outlive it.
// threads >= 1: the bits of the result do not depend on it. interrupted: asked in each iteration of an implicit step,
// which is given up where it says so.
std::unique_ptr<Stepper> make_stepper(const System& system, int threads, std::function<bool()> interrupted = {});

// At most `threads`, and no more than have something to do: a thread sleeps between loops and takes some 50 us to wake,
// in which another is done with the loop of a small body.
int useful_threads(const System& system, int threads);

}  // namespace sim
