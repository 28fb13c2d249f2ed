#include "app/command/commands.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace app {

std::span<const Command> commands() {
  static constexpr Command table[] = {
      {"record", "Step and draw: DIR/frames/frame_00000.png ..., and the numbers", record},
      {"run", "Step only: the numbers, no picture", run},
      {"view", "The window: watch, pull, change parameters", view},
      {"explain", "What is modelled and what it costs, before a step is taken", explain},
      {"trade", "Speed against accuracy, measured: table, plot, advice", trade},
      {"modes", "Vibration modes of the bodies and their frequencies, drawn", modes},
      {"stress", "Stability at the extremes, measured: table and CSV", stress},
      {"residuals", "The weighted residual methods of the lecture, side by side: table, CSV, diagrams", residuals},
      {"scenes", "The scenes that come with it, by the names that every command takes", scenes},
  };
  return table;
}

const Command& find_command(std::string_view name) {
  const auto found = std::ranges::find(commands(), name, &Command::name);
  if (found == commands().end()) throw std::logic_error("no command " + std::string(name));
  return *found;
}

}  // namespace app
