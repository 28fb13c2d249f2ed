#include "app/base/gnuplot.h"

#include <sys/wait.h>

#include "app/base/process.h"

namespace app {

std::string gnuplot_quoted(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '\'' ? 2 : 1, c == '\n' ? ' ' : c);
  return "'" + result + "'";
}

bool run_gnuplot(const std::filesystem::path& script) {
  pid_t process = 0;
  if (start_process({"gnuplot", script.string()}, -1, process) != 0) return false;
  const int status = wait_for_process(process);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace app
