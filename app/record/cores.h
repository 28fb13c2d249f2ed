// How the cores are shared between the stages of a recording. Only its seconds depend on it, never what is drawn.
#pragma once

#include "app/options/options.h"
#include "app/scene/simulation.h"

namespace app {

struct Cores {
  int stepping = 1;  // at least 1
  int drawing = 0;   // what is left for drawing and writing; 0: they run when steps wait
};

// By the work of a drawn frame, told by counts: all of options.threads to steps where few frames are drawn, half of
// them where steps and pictures cost the same.
Cores share_cores(const Simulation& simulation, const Options& options);

// Tells Mesa's rasteriser, before its first context is made; who has set LP_NUM_THREADS knows better.
void give_to_rasteriser(int cores);

}  // namespace app
