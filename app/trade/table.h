// The runs of a trade as a table for reading, and as trade.csv and trade.json.
#pragma once

#include <string>
#include <vector>

#include "app/trade/search.h"

namespace app {

// One line a run, those on the front marked with a star, fastest first; failed and skipped runs below.
std::string table_text(const std::vector<const Score*>& scores, const References& references);

// A header and one row for each run.
std::string trade_csv(const std::vector<const Score*>& scores, const Comparison& comparison);

// The order in time that the runs of each integrator show.
struct Slope {
  std::string integrator;
  int order = 0;     // what theory says
  double slope = 0;  // what is measured
};
std::vector<Slope> slopes(const std::vector<const Score*>& scores);

}  // namespace app
