// One scene, measured: the runs, their errors, the files that they leave.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/trade/plot.h"
#include "app/trade/search.h"

namespace app {

// The folder that the options name; out/trade/NAME of the scene file when they name none.
std::filesystem::path trade_folder(const Options& options);

// Wall time that the measurement may take [s].
double trade_seconds(const TradeOptions& options);

class Trade {
 public:
  // Throws SceneError, std::runtime_error (bad goal, a folder that holds another scene's trade), WriteError.
  Trade(const Options& options, std::filesystem::path folder, double seconds, const Interrupt& interrupt);

  // Measures, keeping trade.csv up to date. False: interrupted.
  bool measure(const std::optional<Plan>& plan);
  // Only from what lies in the folder.
  void collect(const Plan& plan);
  // Table, trade.csv, trade.json, plot; then the advice, verified by a fresh run.
  void report();

  Diagram diagram();

 private:
  struct Advice {
    const Score* chosen = nullptr;
    Score found;
    CaseRun fresh;
  };
  void write_csv();
  void write_json(const Advice& advice);
  void advise(Advice& advice);
  std::string advice_text(const Advice& advice);

  Options options_;
  std::filesystem::path folder_;
  Comparison comparison_;
  Goal goal_;
  Notebook notebook_;
  Scorer scorer_;
  Search search_;
};

// Draws DIR/NAME.svg and .png of these diagrams, or says why not.
void draw(const std::vector<Diagram>& diagrams, const std::filesystem::path& base, bool quiet);

}  // namespace app
