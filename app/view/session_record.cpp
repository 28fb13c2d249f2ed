#include "app/view/session_record.h"

#include <utility>

#include "app/base/output_file.h"

namespace app {

SessionRecord::SessionRecord(const Options& options, int dimension)
    : log_(options, dimension), numbers_(numbers_of(options)) {}

void SessionRecord::check(const Options& options) {
  for (const std::filesystem::path& file : {options.log, numbers_of(options)}) {
    if (std::filesystem::exists(file) && !options.overwrite)
      throw WriteError(file.string() + ": exists already; choose another file for --log or give --overwrite");
  }
}

std::filesystem::path SessionRecord::numbers_of(const Options& options) {
  return std::filesystem::path(options.log).replace_extension(".csv");
}

void SessionRecord::reach_frame() {
  ++frames_;
  waits_ = true;
}

void SessionRecord::write_frame(const std::function<Moment()>& now) {
  if (!std::exchange(waits_, false)) return;
  Moment moment = now();
  moment.frame = frames_;
  numbers_.add(moment);
}

void SessionRecord::end(std::int64_t steps, const sim::State& state) {
  numbers_.close();
  log_.end(steps, state);
}

}  // namespace app
