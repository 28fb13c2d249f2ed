// The diagrams of a trade, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>

#include "app/trade/chart.h"

namespace app {

// The script, with the data in it. `base`: path of the pictures without .svg and .png.
std::string plot_script(const Chart& chart, const std::filesystem::path& base);

}  // namespace app
