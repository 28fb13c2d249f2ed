// Who is told of every frame of a run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/report.h"
#include "sim/state.h"

namespace app {

// Energies at the time of a frame [s, J].
struct Energies {
  double t = 0, kinetic = 0, elastic = 0, potential = 0;
};

// A run at the time of a frame.
struct Moment {
  std::int64_t frame = 0;
  int newton = 0;  // iterations of the step that led here
  sim::State state = {};
  double min_J = 1;                     // smallest det F after that step
  double largest = 0;                   // value that a frame so far has shown in colour (app/colour_values.h)
  std::vector<Energies> energies = {};  // of the frames so far; empty where no picture shows them
  sim::StepReport report = {};          // of that step
};

// Where the seconds of drawing went; zero where nothing is drawn.
struct FrameSeconds {
  double drawing = 0, writing = 0, waiting = 0;
};

class FrameSink {
 public:
  virtual ~FrameSink() = default;
  // `checkpoint`: empty, or the bytes of state.bin, to be written once this frame and all before it are on the disk, so
  // that a run that goes on from it misses no frame. Errors may be thrown here or by a later call.
  virtual void add(Moment moment, std::string checkpoint) = 0;
  // Returns when everything is written; throws when something could not be.
  virtual void finish() = 0;
  virtual FrameSeconds seconds() const = 0;
};

}  // namespace app
