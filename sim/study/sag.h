// How far a body that is held sinks under its weight, before a step is taken: for the picture, which must have room.
#pragma once

#include "sim/system.h"

namespace sim {

// Of body b [m], at most: what sticks out by L of the box that the nodes pinned at the start fill, across gravity,
// bends like a cantilever of the body's least extent H and swings twice as far as it hangs, but never lower than L,
//   w = 3/2 rho g L^4/(E H^2).   [Timoshenko; a beam of height H under its own weight]
// 0 where nothing is pinned.
double expected_sag(const System& system, std::size_t b, const Vec3& gravity);

}  // namespace sim
