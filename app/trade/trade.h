// One scene, measured: the runs, their errors, the files that they leave.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/base/other_load.h"
#include "app/trade/advice_text.h"
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
  // Table, trade.csv, trade.json, diagrams, and the advice, verified by a fresh run.
  Advice report();

  // With the run that checked the advice, where there is one.
  Diagram diagram(const Advice& advice);
  // Draws runs beside each other into DIR/show, or as a video.
  void show(const Advice& advice, const Interrupt& interrupt);

 private:
  void write_csv();
  Advice advise();
  void tell_load();

  Options options_;
  std::filesystem::path folder_;
  Comparison comparison_;
  Goal goal_;
  std::vector<TradeCase> named_;  // refused before the folder is touched
  Notebook notebook_;
  Scorer scorer_;
  Measurement measurement_;
  Search search_;
  OtherLoad load_;
};

// Draws DIR/NAME.svg and .png of these diagrams, and NAME-time of the time errors where the first show total ones; or
// says why not.
void draw(const std::vector<Diagram>& diagrams, const std::filesystem::path& base, bool quiet);

}  // namespace app
