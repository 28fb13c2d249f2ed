// The manual page and the completion of the command line, made from the commands and options themselves.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace app {

// ritz(1), for man.
std::string manual_page(const CLI::App& ritz);

// What `source` teaches bash: commands, their options, the names of the scenes that come with the program.
std::string bash_completion(const CLI::App& ritz);

}  // namespace app
