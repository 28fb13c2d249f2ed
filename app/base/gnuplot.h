// Diagrams, drawn by gnuplot where it is installed.
#pragma once

#include <filesystem>
#include <string>

namespace app {

// Text between a script's single quotes.
std::string gnuplot_quoted(const std::string& text);

// Runs gnuplot on the script; false where there is none, or where it fails.
bool run_gnuplot(const std::filesystem::path& script);

}  // namespace app
