// curves.csv: what the exhibits draw as curves over time, a row for each frame, numbers that read back exactly. A
// resumed run has its curves from there.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/exhibit/trace.h"
#include "app/run/csv.h"
#include "app/run/run_folder.h"
#include "sim/system.h"

namespace app {

// Writes nothing where there is no trace. All calls throw WriteError.
class CurvesLog {
 public:
  // From the start, or going on after `resumed_step`: the traces get what the table has of the frames up to it, and its
  // later rows are cut off. Throws std::runtime_error where the table is not of these traces. They must outlive it.
  CurvesLog(const RunFolder& folder, const sim::System& system, std::vector<Trace*> traces,
            std::optional<std::int64_t> resumed_step);

  // The latest entry of every trace.
  void add(std::int64_t frame);
  void sync();
  void close();

 private:
  std::string header() const;
  void restore(const RunFolder& folder, const sim::System& system, std::int64_t frames);

  std::vector<Trace*> traces_;
  std::optional<Csv> table_;
};

}  // namespace app
