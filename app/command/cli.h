// The command line.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "app/options/options.h"

namespace app {

// Arguments without the program's name. Nothing is returned when the program should end at once, with `exit_code`:
// 0 after help was asked for (and written to `out`), 2 after a mistake (and what was wrong was written to `err`).
std::optional<Options> parse_command_line(const std::vector<std::string>& arguments, std::ostream& out,
                                          std::ostream& err, int& exit_code);

}  // namespace app
