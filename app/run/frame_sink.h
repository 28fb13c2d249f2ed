// Who is told of every frame of a run.
#pragma once

#include <string>

#include "app/picture/moment.h"

namespace app {

// Where the seconds of drawing went; zero where nothing is drawn.
struct FrameSeconds {
  double drawing = 0, writing = 0, waiting = 0;
};

// What drew: the kind of context and its driver; empty where nothing is drawn.
struct DrawnBy {
  std::string context, driver;
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
  virtual DrawnBy drawn_by() const = 0;
  // How many cores are left for steps while frames are made.
  virtual int cores_for_steps() const = 0;
};

}  // namespace app
