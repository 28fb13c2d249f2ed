// What the user wants: the fastest within an error, the most accurate within a time, or the knee between them.
#pragma once

#include <string>

#include "app/options/trade_options.h"
#include "sim/scene.h"

namespace app {

struct Goal {
  enum class Kind {
    knee,
    error,   // value: share of the body's size
    pixels,  // value: pixels
    time     // value: wall seconds per simulated second
  };
  Kind kind = Kind::knee;
  double value = 0;
  std::string text = "the knee";  // as a sentence names it
};

// target: "1%", "0.001", "1px". budget: "33ms" per frame, "60s" or "2min" for the whole scene, "realtime".
// Throws std::runtime_error that says what would be right; so do both together.
Goal read_goal(const TradeOptions& options, const sim::Time& time);

}  // namespace app
