// Cuts a polygon into triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace app {

// The corners of a simple polygon, flat or nearly so, convex or not, as triangles by their numbers among `corners`: by
// clipping ears [Meisters 1975]. A corner on a straight side is none of an ear. No triangles come of a polygon without
// area; nothing, when its sides cross each other.
std::optional<std::vector<std::array<int, 3>>> cut_polygon(const std::vector<Eigen::Vector3d>& corners);

}  // namespace app
