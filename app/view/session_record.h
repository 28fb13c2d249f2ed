// What a session in the window leaves: its inputs in FILE.toml (session_log.h) and, for scenes with exhibits, the
// numbers of its frames in FILE.csv, which are those of numbers.csv of a replay.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "app/options/options.h"
#include "app/picture/moment.h"
#include "app/run/numbers_log.h"
#include "app/session/session_log.h"

namespace app {

// All calls throw WriteError.
class SessionRecord {
 public:
  // Begins the files that --log names.
  SessionRecord(const Options& options, int dimension);
  // Throws WriteError where one of them exists and is not to be overwritten.
  static void check(const Options& options);

  void write(const Event& event) { log_.write(event); }
  // A step has led to a frame: nothing is written of it before the next step, as inputs may change it until then.
  void reach_frame();
  // `now`: the moment of now.
  void write_frame(const std::function<Moment()>& now);
  void end(std::int64_t steps, const sim::State& state);

 private:
  static std::filesystem::path numbers_of(const Options& options);

  SessionLog log_;
  NumbersLog numbers_;
  std::int64_t frames_ = 0;  // that steps have led to
  bool waits_ = true;        // the last of them, or the first frame of all, is not written yet
};

}  // namespace app
