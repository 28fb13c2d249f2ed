// Seams of a surface: open edges that lie on each other, as writers leave them where texture or normal changes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Joins the nodes of open edges that stand at one place: elements refer to the first of each, the others remain
// without one. Closed surfaces that touch have no open edges and stay apart. Told in a remark.
void join_seams(sim::Mesh& mesh, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
