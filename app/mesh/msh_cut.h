// Squares beside triangles become triangles, so that a body is of one kind.
#pragma once

#include <string>
#include <vector>

#include "app/mesh/msh_contents.h"

namespace app {

// Where the elements of the highest dimension are tri3 and quad4, each quad4 is cut into two tri3 in the same groups,
// and the remarks tell how many. Everything else stays as it is. Throws FileError for a square whose sides cross each
// other.
void cut_squares_beside_triangles(MshContents& contents, const std::string& name, std::vector<std::string>& remarks);

}  // namespace app
