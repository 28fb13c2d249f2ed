// The commands of the program, one table. Each returns its exit code; bad input throws SceneError, sim::InputError or
// std::runtime_error, which main reports.
#pragma once

#include <span>
#include <string_view>

#include "app/options/options.h"
#include "sim/mesh/input_error.h"

namespace app {

struct Command {
  std::string_view name, what;
  int (*run)(const Options& options);
};

std::span<const Command> commands();

// Throws std::logic_error for a name that is not in the table.
const Command& find_command(std::string_view name);

int record(const Options& options);
int run(const Options& options);
int view(const Options& options);
int explain(const Options& options);
int trade(const Options& options);
int stress(const Options& options);
int modes(const Options& options);
int residuals(const Options& options);
int scenes(const Options& options);

}  // namespace app
