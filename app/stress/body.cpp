#include "app/stress/body.h"

#include <stdexcept>
#include <vector>

#include "app/base/shipped.h"
#include "app/mesh/mesh_file.h"
#include "sim/element/element.h"
#include "sim/mesh/check.h"
#include "sim/mesh/generate.h"

namespace app {
namespace {

// Tens to hundreds of elements, 2 m long.
sim::Mesh block(const TestBody& body) {
  const sim::ElementInfo& info = *sim::find_element(body.element);
  if (info.dimension == 3) {
    const int n = info.simplex() && info.order == 1 ? 2 : 1;
    return sim::generate_box({2, 1, 1}, {2 * n, n, n}, {1, 1, 1}, info.kind);
  }
  const int n = info.order == 1 ? 4 : 2;
  return sim::generate_rectangle({2, 1}, {2 * n, n}, {1, 1}, info.kind);
}

// A membrane.
sim::Mesh sheet(const TestBody& body) {
  const sim::ElementInfo& info = *sim::find_element(body.element);
  const int n = info.order == 1 ? 4 : 2;
  return sim::generate_sheet({2, 1}, {2 * n, n}, {1, 1}, info.kind);
}

// 2 m long and a tenth as thick: two linear elements across, or a quadratic one.
sim::Mesh beam(const TestBody& body) {
  const sim::ElementInfo& info = *sim::find_element(body.element);
  const int n = info.order == 1 ? 2 : 1;
  if (info.dimension == 3) return sim::generate_box({2, 0.2, 0.2}, {10 * n, n, n}, {1, 1, 1}, info.kind);
  return sim::generate_rectangle({2, 0.2}, {10 * n, n}, {1, 1}, info.kind);
}

sim::Mesh stored(const TestBody& body) {
  const std::filesystem::path folder = shipped_folder();
  if (folder.empty())
    throw std::runtime_error(
        "the meshes that come with Ritz lie neither in ../assets nor in ../share/ritz, seen from "
        "the program; name a scene to put its bodies to the test");
  std::vector<std::string> remarks;
  sim::Mesh mesh = read_mesh(folder / "meshes" / body.file, remarks);
  sim::check_and_orient(mesh);
  return mesh;
}

constexpr TestBody table[] = {
    {"tet4", "tet4", Part::reference, 1, block},
    {"tri3", "tri3", Part::element, 1, block},
    {"tri6", "tri6", Part::element, 1, block},
    {"quad4", "quad4", Part::element, 1, block},
    {"tet10", "tet10", Part::element, 1, block},
    {"hex8", "hex8", Part::element, 1, block},
    {"tri3 sheet", "tri3", Part::shape, 0.01, sheet},
    {"tri6 sheet", "tri6", Part::shape, 0.01, sheet},
    {"star", "tet4", Part::shape, 1, stored, "star.msh"},
    {"shell", "tet4", Part::shape, 1, stored, "shell.msh"},
    {"annulus", "tri3", Part::shape, 1, stored, "annulus.msh"},
    {"two parts", "tet4", Part::shape, 1, stored, "two-parts.msh"},
    {"tri3 beam", "tri3", Part::beam, 1, beam},
    {"quad4 beam", "quad4", Part::beam, 1, beam},
    {"tri6 beam", "tri6", Part::beam, 1, beam},
    {"tet4 beam", "tet4", Part::beam, 1, beam},
    {"hex8 beam", "hex8", Part::beam, 1, beam},
    {"tet10 beam", "tet10", Part::beam, 1, beam},
};

}  // namespace

std::span<const TestBody> test_bodies() {
  return table;
}

}  // namespace app
