#include "app/run/numbers_log.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

namespace app {
namespace {

constexpr const char* header = "frame,name,value,unit\n";

// Rows of the frames up to the last one.
std::int64_t rows_until(const std::filesystem::path& path, std::int64_t last_frame) {
  std::ifstream file(path);
  std::string row;
  std::getline(file, row);
  std::int64_t rows = 0;
  while (std::getline(file, row) && std::strtoll(row.c_str(), nullptr, 10) <= last_frame) ++rows;
  return rows;
}

}  // namespace

NumbersLog::NumbersLog(std::filesystem::path file, std::optional<std::int64_t> resumed_frame) : file_(std::move(file)) {
  if (!resumed_frame || !std::filesystem::exists(file_)) return;
  table_.emplace(file_, header, rows_until(file_, *resumed_frame));
}

void NumbersLog::add(const Moment& moment) {
  if (!moment.sheet) return;
  if (!table_) table_.emplace(file_, header);
  for (const render::Number& number : render::numbers_of(*moment.sheet)) {
    table_->row(std::to_string(moment.frame) + "," + number.name + "," + number.text + "," + number.unit + "\n");
  }
}

void NumbersLog::sync() {
  if (table_) table_->sync();
}

void NumbersLog::close() {
  if (table_) table_->close();
}

}  // namespace app
