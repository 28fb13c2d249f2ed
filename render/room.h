// Where bodies stand in a picture so that nothing written or plotted covers them.
#pragma once

#include <string>

#include "render/frame.h"

namespace render {

// What stands around the bodies, the same in every frame of a run.
struct Contents {
  std::string title = {};
  std::string caption = {};  // about as long as it will be
  bool labels = false;       // above bodies
  int strips = 0;
  std::string legend = {};  // its heading; empty: no legend
  Look look = {};
};

// The size of the letters in a picture of width x height pixels.
float text_size(float width, float height, bool lecture);

// Whether the scene keeps a quarter of the height beside strips and all else; on a small picture it may not.
bool has_room_for_strips(const Contents& contents, int width, int height);

// The part of such a picture that is left. Words are taken to be as long as letters are in the mean, so that no font is
// needed; at least a third of either side is left whatever stands there.
Box room_for(const Contents& contents, int width, int height);

}  // namespace render
