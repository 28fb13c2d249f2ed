// The program `ritz`: reads the command line, runs a command, turns exceptions into exit codes.
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <thread>

#include "app/base/exit_code.h"
#include "app/command/cli.h"
#include "app/command/commands.h"
#include "app/scene/scene_error.h"

namespace {

// Threads that wait for work are to sleep: by default OpenMP's spin, and take the cores from drawing and encoding
// (a recording then takes about 1.5 times as long on 2 cores). No team is to have more threads than there are cores:
// CHOLMOD asks for 4, and OpenMP makes threads anew whenever a team has another size than the one before (steps of the
// bear on 2 cores then take 1.3 times as long). libgomp reads both when it is loaded, so the program starts itself once
// more with them set; where that fails it goes on as it is.
void set_threads_of_openmp(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  const unsigned cores = std::thread::hardware_concurrency();
  if (cores > 0) setenv("OMP_THREAD_LIMIT", std::to_string(cores).c_str(), 0);
  execv("/proc/self/exe", argv);
}

}  // namespace

int main(int argc, char** argv) {
  set_threads_of_openmp(argv);
  try {
    int exit_code = app::exit_done;
    const auto options = app::parse_command_line({argv + 1, argv + argc}, std::cout, std::cerr, exit_code);
    return options ? app::find_command(options->command).run(*options) : exit_code;
  } catch (const app::SceneError& error) {
    // All that is wrong with a scene, a line each.
    std::istringstream lines(error.what());
    for (std::string line; std::getline(lines, line);) std::cerr << "ritz: " << line << '\n';
    return app::exit_bad_input;
  } catch (const std::bad_alloc&) {
    std::cerr << "ritz: out of memory: take a coarser mesh\n";
    return app::exit_numerical_failure;
  } catch (const std::exception& error) {
    std::cerr << "ritz: " << error.what() << '\n';
    return app::exit_bad_input;
  }
}
