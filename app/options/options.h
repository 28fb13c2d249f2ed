// What the command line says: one struct for all commands. Keys of the scene that have an option of their own
// (--seconds, --fps) arrive as overrides.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/options/trade_options.h"

namespace app {

// A key of the scene set from outside: "body.0.material.poisson" = "0.49".
struct Override {
  std::string key;
  std::string value;   // TOML, or a bare string
  std::string origin;  // what messages say it came from: "--set body.0.material.poisson=0.49"
};

struct Options {
  std::string command = "record";           // a name in app/command/commands.cpp
  std::filesystem::path scene;              // the TOML file
  std::filesystem::path settings;           // TOML file whose keys overlay the scene; empty: none
  std::vector<Override> overrides;          // the last one wins
  std::filesystem::path out;                // the run folder; empty: out/NAME of the scene file
  std::filesystem::path resume;             // run folder whose state.bin to go on from; empty: from the start
  std::filesystem::path cache;              // where bases are kept for the next run; empty: nowhere
  int threads = 1;                          // >= 1; the command line fills in the number of cores
  std::uint64_t seed = 1;                   // of everything random in a scene
  bool quiet = false;                       // no progress, only errors
  bool overwrite = false;                   // existing frames may be replaced
  bool vtu = false;                         // VTU files and a .pvd beside the frames
  int width = 1280, height = 720;           // of a frame, pixels
  int every = 1;                            // draw frames 0, n, 2n, ...
  bool still = false;                       // draw the last frame only
  std::string context;                      // record: a kind in render/context.h that draws; empty: the default
  int samples = 4;                          // per pixel: 1, 2, 4 or 8
  std::filesystem::path expect;             // folder of stored frames to compare with; empty: none
  int expect_difference = 8;                // of a channel, 0 to 255: up to it pixels count as equal
  double expect_share = 0.001;              // of the pixels that may differ by more
  std::filesystem::path video;              // frames are piped to ffmpeg; empty: no video
  bool quick = false;                       // stress: a part of the matrix, under a minute
  int seeds = 1;                            // stress: runs of each case, with seeds one after the other
  std::string only;                         // stress: the cases whose name has this in it; empty: all
  std::filesystem::path replay;             // record: the session to draw again; empty: none
  bool panel = false;                       // record: the panel is drawn into the frames
  std::vector<std::filesystem::path> deck;  // view: the pages, of which `scene` is the first
  std::filesystem::path log;                // view: where the session is written; empty: nowhere
  int count = 6;                            // modes: of each body
  bool names = false;                       // scenes: print their names only
  bool keys = false;                        // explain: print the reference of the keys, no scene
  std::filesystem::path compare;            // explain: a run of all nodes, beside which a basis is put; empty: none
  std::filesystem::path problem;            // residuals: the problem file; empty: those that come with the program
  bool anyway = false;                      // residuals: Ritz's method where L is not self-adjoint too
  TradeOptions trade;
};

}  // namespace app
