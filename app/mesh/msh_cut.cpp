#include "app/mesh/msh_cut.h"

#include <algorithm>

#include "app/mesh/error.h"
#include "app/mesh/polygon.h"

namespace app {
namespace {

constexpr int triangle_number = 2, square_number = 3;  // Gmsh's

bool has(const MshContents& contents, int number) {
  return std::ranges::any_of(contents.blocks,
                             [&](const MshBlock& b) { return b.type->number == number && !b.nodes.empty(); });
}

MshBlock cut(const MshBlock& squares, const std::vector<double>& coordinates, const std::string& name) {
  MshBlock triangles{find_msh_type(triangle_number), squares.physical, {}};
  for (std::size_t first = 0; first < squares.nodes.size(); first += 4) {
    std::vector<Eigen::Vector3d> corners;
    for (std::size_t k = 0; k < 4; ++k)
      corners.emplace_back(&coordinates[3 * static_cast<std::size_t>(squares.nodes[first + k])]);
    const auto parts = cut_polygon(corners);
    if (!parts || parts->size() != 2)
      throw FileError(name + ": square " + std::to_string(first / 4 + 1) +
                      " of its group beside triangles has sides that cross each other, or no area");
    for (const std::array<int, 3>& part : *parts)
      for (const int corner : part) triangles.nodes.push_back(squares.nodes[first + static_cast<std::size_t>(corner)]);
  }
  return triangles;
}

}  // namespace

void cut_squares_beside_triangles(MshContents& contents, const std::string& name, std::vector<std::string>& remarks) {
  const bool is_solid = std::ranges::any_of(contents.blocks, [](const MshBlock& b) { return b.type->dimension == 3; });
  if (is_solid || !has(contents, triangle_number) || !has(contents, square_number)) return;
  std::size_t count = 0;
  for (MshBlock& block : contents.blocks) {
    if (block.type->number != square_number) continue;
    count += block.nodes.size() / 4;
    block = cut(block, contents.coordinates, name);
  }
  remarks.push_back(name + ": squares beside triangles, cut into two triangles each: " + std::to_string(count));
}

}  // namespace app
