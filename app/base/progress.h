// How far a run is: a bar where someone watches, plain lines where a log is kept.
#pragma once

#include <chrono>
#include <cstdint>
#include <ostream>
#include <string>

namespace app {

enum class ProgressStyle { silent, lines, bar };

// silent when quiet, a bar when stderr is a terminal, lines otherwise.
ProgressStyle progress_style(bool quiet);

struct ProgressPlan {
  std::int64_t first_step = 0, last_step = 0;
  double step_seconds = 0;  // simulated, h
};

class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  Progress(std::ostream& out, ProgressStyle style, const ProgressPlan& plan, Clock::time_point start);
  // Prints when enough time has passed since the last print.
  void update(std::int64_t step, Clock::time_point now);
  // What follows in every later print.
  void note(std::string text) { note_ = std::move(text); }
  // The last word: total time and real-time factor.
  void finish(std::int64_t step, Clock::time_point now);

 private:
  std::string text(std::int64_t step, Clock::time_point now) const;

  std::ostream& out_;
  ProgressStyle style_;
  ProgressPlan plan_;
  Clock::time_point start_, printed_;
  std::string note_;
};

// "[######..................] "
std::string progress_bar(double share);

// "1:05" or "2:03:09": minutes and seconds, hours where needed.
std::string clock_text(double seconds);

}  // namespace app
