#include "app/mesh/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <map>

#include "app/mesh/binary.h"
#include "app/mesh/face_set.h"

namespace app {
namespace {

// Vertices by where they stand.
class StlCorners {
 public:
  explicit StlCorners(FaceSet& faces) : faces_(faces) {}

  int find(const Eigen::Vector3d& X) {
    const std::array<double, 3> key = {X.x() + 0.0, X.y() + 0.0, X.z() + 0.0};  // -0 becomes 0
    const auto [at, is_new] = numbers_.try_emplace(key, static_cast<int>(faces_.vertices.size()));
    if (is_new) faces_.vertices.push_back(X);
    return at->second;
  }

 private:
  FaceSet& faces_;
  std::map<std::array<double, 3>, int> numbers_;
};

// Triangles two of whose corners stand at one place have no area: they are counted, not added.
void add_triangle(const Cursor& in, const std::array<Eigen::Vector3d, 3>& X, StlCorners& corners, FaceSet& faces,
                  int& collapsed) {
  const std::vector<int> triangle = {corners.find(X[0]), corners.find(X[1]), corners.find(X[2])};
  if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
    ++collapsed;
  } else {
    faces.add(in, triangle);
  }
}

// solid NAME, facet normal x y z, outer loop, three times vertex x y z, endloop, endfacet, ..., endsolid NAME.
int read_text_stl(Cursor& in, FaceSet& faces) {
  StlCorners corners(faces);
  int collapsed = 0;
  while (!in.finished()) {
    const std::string word = in.keyword("solid, facet or endsolid");
    if (word == "SOLID") faces.put_in({std::string(in.rest_of_line())});
    if (word == "ENDSOLID") in.rest_of_line();
    if (word == "SOLID" || word == "ENDSOLID") continue;
    if (word != "FACET") in.fail(quote(word) + " stands where solid, facet or endsolid should be");
    in.rest_of_line();
    in.expect_keyword("outer");
    in.expect_keyword("loop");
    std::array<Eigen::Vector3d, 3> X;
    for (Eigen::Vector3d& corner : X) {
      in.expect_keyword("vertex");
      for (double& x : corner) x = in.real("a coordinate");
    }
    in.expect_keyword("endloop");
    in.expect_keyword("endfacet");
    add_triangle(in, X, corners, faces, collapsed);
  }
  return collapsed;
}

constexpr std::size_t stl_header = 80, stl_triangle = 50;  // bytes

// 80 bytes of any kind, the number of triangles, then 12 floats and two bytes of each, in the order of Intel.
int read_binary_stl(Cursor& in, FaceSet& faces) {
  constexpr bool swapped = std::endian::native != std::endian::little;
  in.use_offsets();
  in.bytes(stl_header, "the header");
  const auto said = from_bytes<std::uint32_t>(in.bytes(4, "the number of triangles"), swapped);
  const int count = in.checked_count(said, stl_triangle, "the number of triangles");
  StlCorners corners(faces);
  int collapsed = 0;
  for (int t = 0; t < count; ++t) {
    const std::string_view bytes = in.bytes(stl_triangle, "a triangle");
    std::array<Eigen::Vector3d, 3> X;
    for (std::size_t i = 0; i < 9; ++i) {
      const double x = from_bytes<float>(bytes.substr(4 * (3 + i)), swapped);
      if (!std::isfinite(x)) in.fail("a coordinate is " + std::to_string(x) + "; it should be a finite number");
      X[i / 3][static_cast<Eigen::Index>(i % 3)] = x;
    }
    add_triangle(in, X, corners, faces, collapsed);
  }
  return collapsed;
}

std::size_t find_in_capitals_or_not(std::string_view content, std::string_view word) {
  const auto capital = [](char c) { return std::toupper(static_cast<unsigned char>(c)); };
  const auto found = std::ranges::search(content, word, {}, capital, capital);
  return found.empty() ? content.npos : static_cast<std::size_t>(found.begin() - content.begin());
}

// The header of a binary file may start with "solid" as well; but text has no zero bytes, and facets.
bool is_binary_stl(std::string_view content) {
  if (content.find_first_not_of(" \t\r\n") == find_in_capitals_or_not(content, "solid") &&
      find_in_capitals_or_not(content, "facet") != content.npos && content.find('\0') == content.npos) {
    return false;
  }
  return content.size() >= stl_header + 4;
}

}  // namespace

sim::Mesh read_stl(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name);
  FaceSet faces(0);
  const int collapsed = is_binary_stl(content) ? read_binary_stl(in, faces) : read_text_stl(in, faces);
  if (collapsed > 0) {
    remarks.push_back(std::string(name) +
                      ": faces with two corners at one place, left out: " + std::to_string(collapsed));
  }
  return faces.mesh(in, remarks);
}

}  // namespace app
