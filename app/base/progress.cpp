#include "app/base/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "app/base/text.h"

namespace app {
namespace {

constexpr int bar_width = 24;
constexpr double bar_pause = 0.1;    // s between two prints
constexpr double lines_pause = 3.0;  // s

double seconds_between(Progress::Clock::time_point from, Progress::Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string progress_bar(double share) {
  const int full = static_cast<int>(share * bar_width);
  return "[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(bar_width - full), '.') + "] ";
}

ProgressStyle progress_style(bool quiet) {
  if (quiet) return ProgressStyle::silent;
  return isatty(STDERR_FILENO) == 1 ? ProgressStyle::bar : ProgressStyle::lines;
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(std::clamp(seconds, 0.0, 1e9)));
  const auto hours = static_cast<int>(whole / 3600);
  const auto minutes = static_cast<int>(whole / 60 % 60);
  const auto rest = static_cast<int>(whole % 60);
  return hours > 0 ? formatted("%d:%02d:%02d", hours, minutes, rest) : formatted("%d:%02d", minutes, rest);
}

Progress::Progress(std::ostream& out, ProgressStyle style, const ProgressPlan& plan, Clock::time_point start)
    : out_(out), style_(style), plan_(plan), start_(start), printed_(start) {}

void Progress::update(std::int64_t step, Clock::time_point now) {
  if (style_ == ProgressStyle::silent) return;
  const bool as_bar = style_ == ProgressStyle::bar;
  if (seconds_between(printed_, now) < (as_bar ? bar_pause : lines_pause)) return;
  printed_ = now;
  const double share = static_cast<double>(step) / static_cast<double>(std::max<std::int64_t>(plan_.last_step, 1));
  if (as_bar) {
    out_ << '\r' << progress_bar(share) << text(step, now) << "\x1b[K" << std::flush;
  } else {
    out_ << text(step, now) << std::endl;
  }
}

void Progress::finish(std::int64_t step, Clock::time_point now) {
  if (style_ == ProgressStyle::silent) return;
  if (style_ == ProgressStyle::bar) out_ << "\r\x1b[K";
  const double wall = seconds_between(start_, now);
  const double simulated = static_cast<double>(step - plan_.first_step) * plan_.step_seconds;
  out_ << formatted("%lld steps, %.3g s simulated in %.3g s: %.2f times real time",
                    static_cast<long long>(step - plan_.first_step), simulated, wall, wall > 0 ? simulated / wall : 0.0)
       << std::endl;
}

// "step 120/300, t = 2.00 s, 0.85 times real time, 0:12 left"
std::string Progress::text(std::int64_t step, Clock::time_point now) const {
  const double wall = seconds_between(start_, now);
  const auto taken = static_cast<double>(std::max<std::int64_t>(step - plan_.first_step, 1));
  const double factor = wall > 0 ? taken * plan_.step_seconds / wall : 0.0;
  const double left = wall / taken * static_cast<double>(plan_.last_step - step);
  return formatted("step %lld/%lld, t = %.2f s, %.2f times real time, ", static_cast<long long>(step),
                   static_cast<long long>(plan_.last_step), static_cast<double>(step) * plan_.step_seconds, factor) +
         clock_text(left) + " left" + note_;
}

}  // namespace app
