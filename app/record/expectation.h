// Frames that a run is expected to draw: stored ones, compared with what is drawn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "app/options/options.h"
#include "app/run/run_folder.h"
#include "render/image.h"

namespace app {

// The pictures frame_NNNNN.png of a folder. Those that a run draws are compared; frames that are not stored are not.
class Expectation {
 public:
  // Throws std::runtime_error when options.expect is no folder, holds no such picture, or its first one has another
  // size than the run draws.
  Expectation(const Options& options, const RunFolder& folder);

  // Compares a frame with the stored one, if there is one. Where they differ too much, writes the difference picture.
  // Throws WriteError, and std::runtime_error when the stored picture cannot be read.
  void compare(std::int64_t frame, const render::Image& drawn);

  // Writes expect.csv, one row for each stored frame. Throws WriteError.
  void write_table() const;
  // A sentence on how it went, with a line for each frame that differs or was not drawn.
  std::string summary() const;
  bool fulfilled() const;

 private:
  struct Result {
    bool drawn = false, equal = false;
    int largest = 0;    // channel difference, 0 to 255
    double share = 0;   // of differing pixels
    std::string words;  // on what differs
  };

  std::filesystem::path stored_;
  const RunFolder& folder_;
  int tolerated_;
  double share_;
  std::map<std::int64_t, Result> results_;  // by frame
};

}  // namespace app
