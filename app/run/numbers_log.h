// numbers.csv: every number that the exhibits show, as it is printed, frame by frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/picture/moment.h"
#include "app/run/csv.h"

namespace app {

// Begins with the first frame that shows numbers: a run without exhibits leaves no such file.
class NumbersLog {
 public:
  // Where a run goes on after a frame, what the file has of later ones is cut off.
  explicit NumbersLog(std::filesystem::path file, std::optional<std::int64_t> resumed_frame = {});

  // Throws WriteError, as the others do.
  void add(const Moment& moment);
  void sync();
  void close();

 private:
  std::filesystem::path file_;
  std::optional<Csv> table_;
};

}  // namespace app
