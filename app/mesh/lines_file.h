// Lines in a file: an MSH mesh of which nothing has more than one dimension.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>

namespace app {

struct MeshLines {
  Eigen::Matrix2Xd X;  // m, in the plane z = 0
  Eigen::Matrix2Xi lines;
};

// Lines with a node in the middle are cut there. None where the file holds something else. Throws FileError.
std::optional<MeshLines> read_lines(const std::filesystem::path& path);

}  // namespace app
