// Diagrams of a study, made by gnuplot.
#pragma once

#include <filesystem>
#include <string>

#include "app/residuals/study.h"

namespace app {

// The script, with the data in it, of two pictures: base-solutions.svg, for each basis u and u_n of every method above
// their residuals (of hats, which have none, the errors); base-convergence.svg, the errors over n with their orders.
// Both also as .png.
std::string residual_plot_script(const ResidualStudy& study, const std::filesystem::path& base);

}  // namespace app
