#include "app/mesh/lines_file.h"

#include <algorithm>
#include <vector>

#include "app/mesh/contents.h"
#include "app/mesh/formats.h"
#include "app/mesh/msh.h"

namespace app {
namespace {

int dimension_of(const MshContents& contents) {
  int dimension = 0;
  for (const MshBlock& block : contents.blocks)
    if (!block.nodes.empty()) dimension = std::max(dimension, block.type->dimension);
  return dimension;
}

// A line's ends come first, then its middle.
std::vector<int> line_ends(const MshContents& contents) {
  std::vector<int> ends;
  for (const MshBlock& block : contents.blocks) {
    if (block.type->dimension != 1) continue;
    const auto nodes = static_cast<std::size_t>(block.type->nodes);
    for (std::size_t at = 0; at < block.nodes.size(); at += nodes) {
      const int *line = block.nodes.data() + at, middle = line[nodes - 1];
      if (nodes == 2)
        ends.insert(ends.end(), {line[0], line[1]});
      else
        ends.insert(ends.end(), {line[0], middle, middle, line[1]});
    }
  }
  return ends;
}

}  // namespace

std::optional<MeshLines> read_lines(const std::filesystem::path& path) {
  const MeshFormat* const format = find_mesh_format(path.string());
  if (format == nullptr || format->read != read_msh) return std::nullopt;
  const MshContents contents = read_msh_contents(read_contents(path), path.string());
  if (dimension_of(contents) != 1) return std::nullopt;
  std::vector<int> ends = line_ends(contents), used = ends;
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  MeshLines result;
  result.X.resize(2, static_cast<Eigen::Index>(used.size()));
  for (std::size_t k = 0; k < used.size(); ++k) {
    const double* const x = contents.coordinates.data() + 3 * static_cast<std::size_t>(used[k]);
    result.X.col(static_cast<Eigen::Index>(k)) << x[0], x[1];
  }
  for (int& node : ends) node = static_cast<int>(std::ranges::lower_bound(used, node) - used.begin());
  result.lines = Eigen::Map<const Eigen::Matrix2Xi>(ends.data(), 2, static_cast<Eigen::Index>(ends.size() / 2));
  return result;
}

}  // namespace app
