#include "app/trade/goal.h"

#include <charconv>
#include <stdexcept>

namespace app {
namespace {

// A number > 0 and the unit behind it.
struct Amount {
  double value = 0;
  std::string unit;
};

Amount read_amount(const std::string& option, const std::string& text, const std::string& right) {
  Amount amount;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, amount.value);
  amount.unit.assign(rest, end);
  const bool positive = error == std::errc{} && amount.value > 0 && amount.value < 1e12;
  if (!positive) throw std::runtime_error(option + " " + text + ": must be " + right);
  return amount;
}

Goal read_target(const std::string& text) {
  const std::string right = "a share of the body's size (1%, 0.01) or pixels at 1080p (1px)";
  const Amount amount = read_amount("--target", text, right);
  if (amount.unit == "%") return {Goal::Kind::error, amount.value / 100, "an error of " + text};
  if (amount.unit.empty()) return {Goal::Kind::error, amount.value, "an error of " + text + " of the body's size"};
  if (amount.unit == "px") return {Goal::Kind::pixels, amount.value, "an error of " + text + " at 1080p"};
  throw std::runtime_error("--target " + text + ": must be " + right);
}

Goal read_budget(const std::string& text, const sim::Time& time) {
  if (text == "realtime") return {Goal::Kind::time, 1, "real time"};
  const std::string right = "a time per frame (33ms), for the whole scene (60s, 2min), or realtime";
  const Amount amount = read_amount("--budget", text, right);
  if (amount.unit == "ms") return {Goal::Kind::time, amount.value / 1000 * time.fps, text + " a frame"};
  if (amount.unit == "s") return {Goal::Kind::time, amount.value / time.seconds, text + " for the whole scene"};
  if (amount.unit == "min") return {Goal::Kind::time, amount.value * 60 / time.seconds, text + " for the whole scene"};
  throw std::runtime_error("--budget " + text + ": must be " + right);
}

}  // namespace

Goal read_goal(const TradeOptions& options, const sim::Time& time) {
  if (!options.target.empty() && !options.budget.empty())
    throw std::runtime_error("--target and --budget: give one of them, the other is the answer");
  if (!options.target.empty()) return read_target(options.target);
  if (!options.budget.empty()) return read_budget(options.budget, time);
  return {};
}

}  // namespace app
