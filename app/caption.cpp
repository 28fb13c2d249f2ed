#include "app/caption.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string_view>

namespace app {
namespace {

std::string formatted(const char* format, double number) {
  char text[40];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

struct Value {
  std::string name;
  std::string (*text)(const sim::System&, const Moment&);
};

const std::vector<Value>& values() {
  using sim::System;
  static const std::vector<Value> table = {
      {"t", [](const System& s, const Moment& m) { return formatted("%.2f", s.time(m.state.step)); }},
      {"frame", [](const System&, const Moment& m) { return std::to_string(m.frame); }},
      {"steps", [](const System&, const Moment& m) { return std::to_string(m.state.step); }},
      {"step", [](const System& s, const Moment&) { return formatted("%.4g", s.step_seconds()); }},
      {"energy",
       [](const System& s, const Moment& m) {
         const sim::Measures now = s.measure(m.state);
         return formatted("%.4g", now.kinetic + now.elastic + now.potential);
       }},
      {"kinetic", [](const System& s, const Moment& m) { return formatted("%.4g", s.measure(m.state).kinetic); }},
      {"elastic", [](const System& s, const Moment& m) { return formatted("%.4g", s.measure(m.state).elastic); }},
      {"potential", [](const System& s, const Moment& m) { return formatted("%.4g", s.measure(m.state).potential); }},
      {"iterations", [](const System&, const Moment& m) { return std::to_string(m.newton); }},
      {"min_J", [](const System&, const Moment& m) { return formatted("%.3f", m.min_J); }},
      {"nodes", [](const System& s, const Moment&) { return std::to_string(s.counts().nodes); }},
      {"elements", [](const System& s, const Moment&) { return std::to_string(s.counts().elements); }},
  };
  return table;
}

// Calls plain(text) and name(text) for the parts of a text, in their order; a brace that is not closed is plain.
void for_each_part(std::string_view rest, const std::function<void(std::string_view)>& plain,
                   const std::function<void(std::string_view)>& name) {
  while (!rest.empty()) {
    const std::size_t open = rest.find('{');
    const std::size_t close = open == std::string_view::npos ? open : rest.find('}', open);
    if (close == std::string_view::npos) return plain(rest);
    plain(rest.substr(0, open));
    name(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
  }
}

}  // namespace

const std::vector<std::string>& known_caption_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Value& value : values()) all.push_back(value.name);
    return all;
  }();
  return names;
}

std::vector<std::string> caption_names(const std::string& text) {
  std::vector<std::string> names;
  for_each_part(
      text, [](std::string_view) {}, [&](std::string_view name) { names.emplace_back(name); });
  return names;
}

std::string caption(const std::string& text, const sim::System& system, const Moment& moment) {
  std::string result;
  const auto value = [&](std::string_view name) {
    const auto found = std::ranges::find(values(), name, &Value::name);
    result += found != values().end() ? found->text(system, moment) : "{" + std::string(name) + "}";
  };
  for_each_part(
      text, [&](std::string_view plain) { result += plain; }, value);
  return result;
}

}  // namespace app
