// How many threads a body is worth.
#pragma once

#include "sim/system.h"

namespace sim {

// At most `threads`, and no more than have something to do: a thread sleeps between loops and takes some 50 us to wake,
// in which another is done with the loop of a small body. The bits of a result do not depend on it.
int useful_threads(const System& system, int threads);

}  // namespace sim
