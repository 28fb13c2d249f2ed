// What a trade advises, as the user reads it and as programs do.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/trade/search.h"

namespace app {

// What is advised, and what a run found that was made after it was chosen.
struct Advice {
  const Score* chosen = nullptr;  // nullptr: no error is known
  const Score* own = nullptr;     // the scene as it is
  std::unique_ptr<const CaseRun> fresh;
  Score found;  // of it
};

// "0.62 % (2.1 px)"
std::string error_text(const Apart& apart);
// "0.52 % (3.3 px), at most 0.78 %"; "below 0.26 % (1.6 px)" where less cannot be told from nothing.
std::string bounded_text(const Score& score);

// The settings; error and time as predicted and as found; the command: three lines. Notes in front of them say what is
// not as it should be.
std::string advice_text(const Measurement& measurement, const Advice& advice, const std::filesystem::path& settings);

// trade.json
std::string trade_json(Measurement& measurement, const Plan& plan, const Advice& advice);

}  // namespace app
