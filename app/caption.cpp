#include "app/caption.h"

#include <cstdio>
#include <optional>
#include <string_view>

namespace app {
namespace {

std::string formatted(const char* format, double number) {
  char text[40];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::optional<std::string> value_of(std::string_view name, const sim::System& system, const Moment& moment) {
  if (name == "t") return formatted("%.2f", system.time(moment.state.step));
  if (name == "frame") return std::to_string(moment.frame);
  if (name == "step") return formatted("%.4g", system.step_seconds());
  if (name == "iterations") return std::to_string(moment.newton);
  if (name != "energy") return std::nullopt;
  const sim::Measures now = system.measure(moment.state);
  return formatted("%.4g", now.kinetic + now.elastic + now.potential);
}

}  // namespace

std::string caption(const std::string& text, const sim::System& system, const Moment& moment) {
  std::string result;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t open = rest.find('{');
    result += rest.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = rest.find('}', open);
    if (close == std::string_view::npos) return result.append(rest.substr(open));
    const std::string_view name = rest.substr(open + 1, close - open - 1);
    result += value_of(name, system, moment).value_or("{" + std::string(name) + "}");
    rest.remove_prefix(close + 1);
  }
  return result;
}

}  // namespace app
