// VTK files for ParaView: one .vtu per frame, and a .pvd that names them with their times.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim/state.h"
#include "sim/system.h"

namespace app {

// An UnstructuredGrid of all bodies at their deformed positions [m]. Point data: displacement [m], velocity [m/s],
// stress (von Mises, Cauchy) [Pa]; cell data: body (0, 1, ...). Binary, base64, float64.
std::string vtu_text(const sim::System& system, const sim::State& state);

// A collection of files, named from the folder of the .pvd, with their times [s].
std::string pvd_text(const std::vector<std::pair<double, std::string>>& files);

}  // namespace app
