#include "app/mesh/positions.h"

#include <string>

#include "app/mesh/contents.h"
#include "app/mesh/cursor.h"

namespace app {

std::vector<sim::Vec3> read_positions(const std::filesystem::path& path, int dimension) {
  const std::string contents = read_contents(path), name = path.string();
  Cursor in(contents, name, '#');
  std::vector<sim::Vec3> positions;
  while (!in.finished()) {
    sim::Vec3& x = positions.emplace_back(sim::Vec3::Zero());
    for (int axis = 0; axis < dimension; ++axis) {
      if (in.line_finished()) in.fail("a node needs " + std::to_string(dimension) + " numbers");
      x[axis] = in.real("a coordinate");
    }
    if (!in.line_finished()) in.fail("a node has " + std::to_string(dimension) + " numbers and no more");
  }
  if (positions.empty()) in.fail("holds no node");
  return positions;
}

}  // namespace app
