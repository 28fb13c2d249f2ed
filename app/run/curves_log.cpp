#include "app/run/curves_log.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

#include "app/base/number_text.h"

namespace app {

CurvesLog::CurvesLog(const RunFolder& folder, const sim::System& system, std::vector<Trace*> traces,
                     std::optional<std::int64_t> resumed_step)
    : traces_(std::move(traces)) {
  if (traces_.empty()) return;
  if (!resumed_step) {
    table_.emplace(folder.curves(), header());
    return;
  }
  const std::int64_t frames = *resumed_step / system.steps_per_frame() + 1;
  table_.emplace(folder.curves(), header(), frames);
  restore(folder, system, frames);
}

std::string CurvesLog::header() const {
  std::string line = "frame";
  for (const Trace* trace : traces_)
    for (const std::string& name : trace->names()) line += "," + name;
  return line + "\n";
}

// The rows have as many numbers as the header has names: only this class writes them.
void CurvesLog::restore(const RunFolder& folder, const sim::System& system, std::int64_t frames) {
  std::ifstream file(folder.curves());
  std::string row;
  std::getline(file, row);
  for (std::int64_t frame = 0; frame < frames && std::getline(file, row); ++frame) {
    const char* at = row.c_str() + row.find(',');
    for (Trace* trace : traces_) {
      Eigen::VectorXd values(static_cast<Eigen::Index>(trace->names().size()));
      for (double& value : values) {
        char* end = nullptr;
        value = std::strtod(at + 1, &end);
        at = end;
      }
      trace->add(system.time(frame * system.steps_per_frame()), values);
    }
  }
}

void CurvesLog::add(std::int64_t frame) {
  if (!table_) return;
  std::string row;
  append_number(row, frame);
  for (const Trace* trace : traces_)
    for (const double value : trace->last()) {
      row += ',';
      append_number(row, value);
    }
  table_->row(row + "\n");
}

void CurvesLog::sync() {
  if (table_) table_->sync();
}

void CurvesLog::close() {
  if (table_) table_->close();
}

}  // namespace app
