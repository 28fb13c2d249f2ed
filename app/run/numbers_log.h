// numbers.csv: every number that the exhibits show, as it is printed, frame by frame.
#pragma once

#include <optional>

#include "app/picture/moment.h"
#include "app/run/csv.h"
#include "app/run/run_folder.h"

namespace app {

// Begins with the first frame that shows numbers: a run without exhibits leaves no such file.
class NumbersLog {
 public:
  explicit NumbersLog(const RunFolder& folder) : folder_(folder) {}

  // Throws WriteError, as close does.
  void add(const Moment& moment);
  void close();

 private:
  const RunFolder& folder_;
  std::optional<Csv> table_;
};

}  // namespace app
