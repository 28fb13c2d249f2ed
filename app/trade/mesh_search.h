// Measures meshes against the finest that fits into the time, then joins them with the steps that were measured.
#pragma once

#include "app/trade/lists.h"
#include "app/trade/measurement.h"

namespace app {

class MeshSearch {
 public:
  // `time`: scheme and step of all runs of which mesh errors are taken.
  MeshSearch(Measurement& measurement, TradeCase time) : m_(measurement), time_(std::move(time)) {}

  // False: no finer mesh could be afforded or made, and a note says so.
  bool measure();
  // Schemes and steps of the time axis on the other meshes: those of which it can be expected that they are worth it.
  void combine();

 private:
  const CaseRun* find_finest(std::vector<MeshChange>& changes, double seconds);
  void judge(const CaseRun& finest);

  Measurement& m_;
  TradeCase time_;
};

}  // namespace app
