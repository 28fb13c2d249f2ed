#include <cstdio>
#include <iostream>

#include "app/base/exit_code.h"
#include "app/base/shipped.h"
#include "app/command/commands.h"
#include "app/scene/simulation.h"

namespace app {
namespace {

// A line of the table: what is computed, and how often.
void print_scene(const std::string& name, const Options& options) {
  const Simulation simulation = build_simulation(options);
  char numbers[80];
  std::snprintf(numbers, sizeof numbers, "%8d %8lld %8lld", simulation.system->counts().dofs,
                static_cast<long long>(simulation.last_step()), static_cast<long long>(simulation.last_frame() + 1));
  std::cout << name << std::string(name.size() < 34 ? 34 - name.size() : 1, ' ') << numbers << "  "
            << simulation.document.title << '\n';
}

}  // namespace

int scenes(const Options& options) {
  const std::vector<std::string> names = shipped_scenes();
  if (names.empty()) throw std::runtime_error("no scenes are beside the program, in ../share/ritz/scenes");
  if (!options.names) std::cout << "scene                                 dofs    steps   frames  title\n";
  for (const std::string& name : names) {
    if (options.names) {
      std::cout << name << '\n';
      continue;
    }
    Options one = options;
    one.scene = find_scene(name);
    print_scene(name, one);
  }
  return exit_done;
}

}  // namespace app
