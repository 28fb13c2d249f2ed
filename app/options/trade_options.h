// What the command line says to `ritz trade` alone.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct TradeOptions {
  double minutes = 5;                   // wall time that the measurement may take
  bool quick = false;                   // under one minute
  std::string target;                   // "1%", "1px"; empty: none
  std::string budget;                   // "33ms", "60s", "realtime"; empty: none
  bool keep_mesh = false;               // the mesh is given: no other is tried, and the target bounds the time error
  std::filesystem::path compare;        // a second scene, or settings, on the same diagram
  bool jobs = false;                    // list the independent cases
  std::optional<int> one_case;          // run this one
  bool collect = false;                 // make table and advice of the cases that were run
  bool ablate = false;                  // remove one feature of the scene at a time
  bool show = false;                    // draw runs beside each other ...
  std::vector<std::string> show_names;  // ... these among them
};

}  // namespace app
