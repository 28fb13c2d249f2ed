#include "app/run/vtu.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "sim/mesh/generate.h"

namespace app {
namespace {

// A box of hexahedra, and one of tetrahedra beside it.
sim::Scene two_bodies() {
  sim::Scene scene;
  for (const sim::ElementKind kind : {sim::ElementKind::hex8, sim::ElementKind::tet10}) {
    sim::Body body;
    body.name = kind == sim::ElementKind::hex8 ? "left" : "right";
    body.mesh = sim::generate_box({1, 1, 1}, {2, 1, 1}, {1, 1, 1}, kind);
    body.materials = {sim::MaterialSpec{}};
    scene.bodies.push_back(body);
  }
  return scene;
}

std::string bytes_of_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t value = letters.find(c);
    if (value == std::string::npos) break;
    bits = bits << 6 | static_cast<unsigned>(value);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xff);
  }
  return bytes;
}

// The numbers of a data array by its name.
template <typename Number>
std::vector<Number> array_named(const std::string& text, const std::string& name) {
  const std::size_t tag = text.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) return {};
  const std::size_t begin = text.find('>', tag) + 1;
  const std::string bytes = bytes_of_base64(text.substr(begin, text.find('<', begin) - begin));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  EXPECT_EQ(size + sizeof size, bytes.size()) << name;
  std::vector<Number> numbers(size / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data() + sizeof size, size);
  return numbers;
}

TEST(Vtu, HoldsAllBodiesAtTheirDeformedPositions) {
  const sim::System system(two_bodies());
  sim::State state = system.initial_state();
  state.x.array() += 0.125;
  state.v.setConstant(-2);
  const std::string text = vtu_text(system, state);
  const int nodes = system.counts().nodes;
  EXPECT_NE(text.find("NumberOfPoints=\"" + std::to_string(nodes) + "\" NumberOfCells=\"14\""), std::string::npos);
  const auto points = array_named<double>(text, "points");
  ASSERT_EQ(points.size(), static_cast<std::size_t>(state.x.size()));
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], state.x[static_cast<Eigen::Index>(i)]);
  for (const double u : array_named<double>(text, "displacement")) EXPECT_NEAR(u, 0.125, 1e-15);
  EXPECT_EQ(array_named<double>(text, "velocity"), std::vector<double>(points.size(), -2));
  EXPECT_EQ(array_named<double>(text, "stress").size(), static_cast<std::size_t>(nodes));
}

TEST(Vtu, CellsHaveTheTypesAndNodesOfVtk) {
  const sim::System system(two_bodies());
  const std::string text = vtu_text(system, system.initial_state());
  std::vector<std::uint8_t> types(2, 12);
  types.resize(14, 24);
  EXPECT_EQ(array_named<std::uint8_t>(text, "types"), types);
  const auto ends = array_named<std::int64_t>(text, "offsets");
  const auto nodes = array_named<std::int64_t>(text, "connectivity");
  EXPECT_EQ(ends[1], 16);
  EXPECT_EQ(ends.back(), 16 + 12 * 10);
  EXPECT_EQ(nodes.size(), 16U + 120U);
  EXPECT_EQ(std::ranges::max(nodes), system.counts().nodes - 1);
  EXPECT_EQ(std::ranges::min(std::vector(nodes.begin() + 16, nodes.end())), 12);  // the second body's own nodes
}

TEST(Pvd, NamesFilesWithTheirTimes) {
  const std::string text = pvd_text({{0, "vtu/frame_00000.vtu"}, {1.0 / 30, "vtu/a&b.vtu"}});
  EXPECT_NE(text.find("timestep=\"0\" part=\"0\" file=\"vtu/frame_00000.vtu\"/>"), std::string::npos);
  EXPECT_NE(text.find("timestep=\"0.03333333333333333\" part=\"0\" file=\"vtu/a&amp;b.vtu\"/>"), std::string::npos);
}

}  // namespace
}  // namespace app
