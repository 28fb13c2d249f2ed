// Whether a reference can be trusted.
#pragma once

#include "sim/study/difference.h"

namespace sim {

// Two runs of the reference scheme, with steps h and h/2, and two of a second scheme, with h and 2h, on the same mesh.
struct ReferenceRuns {
  const Trajectory& fine;          // reference scheme, h/2: the reference
  const Trajectory& coarse;        // reference scheme, h
  const Trajectory& other;         // second scheme, h
  const Trajectory& other_coarse;  // second scheme, 2h
};

struct ReferenceCheck {
  double moved = 0;        // rms by which halving the step moves the reference
  double apart = 0;        // rms between the reference and the second scheme
  double other_order = 0;  // log2 of how much nearer halving its step has brought that scheme
  double uncertainty = 0;  // of the reference: the larger of moved and apart
  // The schemes go to one limit: halving its step brings the second a quarter nearer at least, or they are no further
  // apart than twice what the reference moves.
  bool agrees = false;
  int frames = 0;         // frames before the horizon
  double horizon = 0;     // s: up to here positions mean something
  bool diverges = false;  // the horizon is before the end
};

// `meaningless`: a difference [body sizes] from which on positions mean nothing; the horizon is the last frame before
// the reference moves by as much when its step is halved.
ReferenceCheck check_reference(const ReferenceRuns& runs, const SamplePoints& points, double meaningless = 5e-3);

}  // namespace sim
