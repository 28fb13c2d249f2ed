// Kinds of options that several commands have.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>

namespace app {

// An option whose value names something and is never empty: an unset variable of a script must not switch it off.
template <typename Name>
CLI::Option* add_named(CLI::App& command, const std::string& option, Name& value, const std::string& what,
                       const std::string& kind) {
  const auto refuse_empty = [](const std::string& text) {
    return std::string(text.empty() ? "must not be empty" : "");
  };
  return command.add_option(option, value, what)->check(CLI::Validator(refuse_empty, ""))->type_name(kind);
}

// A number from low to high; CLI::Range lets nan pass.
inline CLI::Validator within(double low, double high) {
  const std::string range = CLI::Range(low, high).get_description();
  return {[low, high, range](const std::string& text) {
            const double value = std::strtod(text.c_str(), nullptr);
            return value >= low && value <= high ? std::string() : text + " is not a " + range;
          },
          range};
}

}  // namespace app
