// Diagrams, drawn by gnuplot where it is installed.
#pragma once

#include <filesystem>
#include <string>

namespace app {

// Text between a script's single quotes.
std::string gnuplot_quoted(const std::string& text);

// Runs gnuplot on the script, whose own words go where ours do. Empty when it has drawn; else why it has not, as a
// sentence.
std::string run_gnuplot(const std::filesystem::path& script);

}  // namespace app
