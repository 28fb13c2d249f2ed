// A mesh in a file of any format that is known: app/mesh/formats.cpp lists them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Coordinates are finite, elements refer to nodes that exist, none twice, and every node belongs to an element.
// Orientation and volume are not looked at. What was left out or changed is told in remarks, a line each.
// Throws FileError, with file and line or offset.
sim::Mesh read_mesh(const std::filesystem::path& path, std::vector<std::string>& remarks);

// The same for the bytes of a file, whose format its name's ending tells.
sim::Mesh read_mesh(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
