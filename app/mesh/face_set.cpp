#include "app/mesh/face_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "app/mesh/mesh_nodes.h"
#include "app/mesh/polygon.h"
#include "app/mesh/seams.h"

namespace app {
namespace {

// Ears are searched among all corners for each: more corners than any polygon of use take too long.
constexpr std::size_t most_corners = 5000;

}  // namespace

int FaceSet::checked_vertex(const Cursor& in, std::int64_t index) const {
  const auto count = static_cast<std::int64_t>(vertices.size());
  if (index < 0 || index >= count) {
    in.fail("a face refers to vertex " + std::to_string(index + first_) + "; the number of vertices is " +
            std::to_string(count) + ", the first is " + std::to_string(first_));
  }
  return static_cast<int>(index);
}

void FaceSet::add(const Cursor& in, const std::vector<int>& corners) {
  std::vector<int> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) in.fail("vertex " + std::to_string(*twice + first_) + " stands twice in one face");
  if (corners.size() < 3) in.fail("a face has " + std::to_string(corners.size()) + " corners; it needs three or more");
  if (corners.size() > most_corners) {
    in.fail("a face has " + std::to_string(corners.size()) + " corners; at most " + std::to_string(most_corners) +
            " are read");
  }
  if (corners.size() == 3) {
    triangles_.insert(triangles_.end(), corners.begin(), corners.end());
    places_.push_back(in.item());
    part_.push_back(parts_.size() - 1);
    return;
  }
  ++polygons_;
  std::vector<Eigen::Vector3d> X;
  for (const int corner : corners) X.push_back(vertices[static_cast<std::size_t>(corner)]);
  const auto cut = cut_polygon(X);
  if (!cut) {
    in.fail("a face of " + std::to_string(corners.size()) + " corners has sides that cross: cut it into triangles");
  }
  for (const auto& triangle : *cut) {
    for (const int i : triangle) triangles_.push_back(corners[static_cast<std::size_t>(i)]);
    places_.push_back(in.item());
    part_.push_back(parts_.size() - 1);
  }
}

// The measure of no area is that of sim's check, so that none is refused there.
void FaceSet::drop_flat(const Cursor& in, std::vector<std::string>& remarks) {
  constexpr double rounding = 2e-14;  // of the square of the longest edge
  std::size_t kept = 0, first = 0;
  std::string which;
  for (std::size_t t = 0; t < places_.size(); ++t) {
    const auto X = [&](std::size_t i) { return vertices[static_cast<std::size_t>(triangles_[3 * t + i])]; };
    const Eigen::Vector3d a = X(1) - X(0), b = X(2) - X(0);
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    if (!(a.cross(b).norm() > 2 * rounding * longest)) {
      if (!which.empty()) continue;
      first = t;
      for (std::size_t i = 0; i < 3; ++i) which += " " + std::to_string(triangles_[3 * t + i] + first_);
      continue;
    }
    std::copy_n(triangles_.begin() + static_cast<std::ptrdiff_t>(3 * t), 3,
                triangles_.begin() + static_cast<std::ptrdiff_t>(3 * kept));
    part_[kept] = part_[t];
    ++kept;
  }
  if (kept == places_.size()) return;
  remarks.push_back(in.where(places_[first]) + ": faces without area, left out: " +
                    std::to_string(places_.size() - kept) + " (this is the first, of vertices" + which + ")");
  triangles_.resize(3 * kept);
}

void FaceSet::put_in(const std::vector<std::string>& names) {
  std::vector<std::string>& part = parts_.emplace_back();
  for (const std::string& name : names) {
    const std::size_t first = name.find_first_not_of(" \t");
    if (first != name.npos) part.push_back(name.substr(first, name.find_last_not_of(" \t") - first + 1));
  }
}

std::vector<sim::Group> FaceSet::groups(const sim::Mesh& mesh) const {
  std::map<std::string, sim::Group> by_name;
  for (int t = 0; t < mesh.element_count(); ++t) {
    for (const std::string& name : parts_[part_[static_cast<std::size_t>(t)]]) {
      sim::Group& group = by_name[name];
      if (group.elements.empty() || group.elements.back() != t) group.elements.push_back(t);
    }
  }
  std::vector<sim::Group> groups;
  for (auto& [name, group] : by_name) {
    group.name = name;
    group.dimension = 2;
    for (const int t : group.elements)
      group.nodes.insert(group.nodes.end(), mesh.elements.col(t).begin(), mesh.elements.col(t).end());
    std::sort(group.nodes.begin(), group.nodes.end());
    group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

sim::Mesh FaceSet::mesh(const Cursor& in, std::vector<std::string>& remarks) {
  drop_flat(in, remarks);
  if (triangles_.empty()) {
    in.fail("the file has no face with an area; number of vertices: " + std::to_string(vertices.size()));
  }
  sim::Mesh mesh;
  mesh.kind = sim::ElementKind::tri3;
  mesh.X.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.X.col(static_cast<Eigen::Index>(i)) = vertices[i];
  mesh.elements =
      Eigen::Map<const Eigen::MatrixXi>(triangles_.data(), 3, static_cast<Eigen::Index>(triangles_.size() / 3));
  if (polygons_ > 0) {
    remarks.push_back(in.name() +
                      ": faces of more than three corners, cut into triangles: " + std::to_string(polygons_));
  }
  join_seams(mesh, in.name(), remarks);
  keep_used_nodes(mesh, in.name(), remarks);
  flatten(mesh, in.name());
  mesh.groups = groups(mesh);
  return mesh;
}

}  // namespace app
