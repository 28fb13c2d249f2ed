// The states that a run has left in its VTU files.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "sim/scene.h"

namespace app {

// Displacements of a body of the scene [m]: as many numbers per node as the scene has dimensions x files, in the order
// of their names. The run was of this scene, or of this body alone. Throws FileError.
std::shared_ptr<const Eigen::MatrixXd> read_snapshots(const std::filesystem::path& run, const sim::Scene& scene,
                                                      std::size_t body);

// The frames whose states it has left, rising, as its files are numbered. Throws FileError.
std::vector<std::int64_t> snapshot_frames(const std::filesystem::path& run);

}  // namespace app
