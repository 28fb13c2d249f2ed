#include "app/base/gnuplot.h"

#include <sys/wait.h>

#include <cstring>

#include "app/base/process.h"

namespace app {

std::string gnuplot_quoted(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '\'' ? 2 : 1, c == '\n' ? ' ' : c);
  return "'" + result + "'";
}

std::string run_gnuplot(const std::filesystem::path& script) {
  if (!is_installed("gnuplot"))
    return "no gnuplot here (apt-get install gnuplot-nox); where there is one, gnuplot " + script.string() +
           " draws it";
  pid_t process = 0;
  if (const int error = start_process({"gnuplot", script.string()}, -1, process); error != 0)
    return std::string("gnuplot could not be started: ") + std::strerror(error);
  const int status = wait_for_process(process);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "gnuplot failed on " + script.string() + "; what it said is above";
}

}  // namespace app
