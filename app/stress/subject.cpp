// The bodies that are put to the test.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/stress/case.h"
#include "sim/element/element.h"
#include "sim/mesh/generate.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

// Tens to hundreds of elements; "tri3 sheet" is a membrane.
sim::Mesh mesh_of(std::string_view element, bool sheet) {
  const sim::ElementInfo& info = *sim::find_element(element);
  if (info.dimension == 3) {
    const int n = info.simplex() && info.order == 1 ? 2 : 1;
    return sim::generate_box({2, 1, 1}, {2 * n, n, n}, {1, 1, 1}, info.kind);
  }
  const int n = info.order == 1 ? 4 : 2;
  if (sheet) return sim::generate_sheet({2, 1}, {2 * n, n}, {1, 1}, info.kind);
  return sim::generate_rectangle({2, 1}, {2 * n, n}, {1, 1}, info.kind);
}

// Stretch waves of a body of this size take 0.2 s; damped so that the slowest bending dies within a second.
Subject subject(std::string_view element, bool sheet, std::string_view material, std::string_view scheme) {
  Subject s;
  s.element = std::string(element) + (sheet ? " sheet" : "");
  s.material = material;
  s.scheme = scheme;
  sim::Body body;
  body.name = "body";
  body.mesh = mesh_of(element, sheet);
  body.thickness = sheet ? 0.01 : 1;
  body.materials = {sim::MaterialSpec{s.material, 1e5, 0.45, 1000, ""}};
  body.damping.alpha = 10;
  s.scene.dimension = body.mesh.dimension();
  s.scene.bodies = {body};
  s.scene.world.gravity = {0, 0, 0};
  s.scene.time.integrator = s.scheme;
  if (sim::find_scheme(scheme)->is_explicit()) s.scene.time.substeps = 0;
  return s;
}

constexpr std::string_view materials[] = {"stable-neo-hookean", "fixed-corotated", "corotated"};
constexpr std::string_view schemes[] = {"backward-euler", "sdirk2", "tr-bdf2"};

}  // namespace

std::vector<Subject> built_in_subjects(bool quick) {
  std::vector<Subject> all;
  for (const std::string_view material : materials)
    for (const std::string_view scheme : schemes)
      if (!quick || material == materials[0] || scheme == schemes[0])
        all.push_back(subject("tet4", false, material, scheme));
  if (quick) return all;
  for (const sim::ElementInfo& element : sim::elements())
    for (const std::string_view material : materials)
      if (element.name != "tet4") all.push_back(subject(element.name, false, material, schemes[0]));
  for (const sim::ElementInfo& element : sim::elements())
    if (element.membrane) all.push_back(subject(element.name, true, materials[0], schemes[0]));
  for (const char* material : {"neo-hookean", "stvk", "linear"})
    all.push_back(subject("tet4", false, material, schemes[0]));
  for (const sim::Scheme& scheme : sim::schemes())
    if (std::find(std::begin(schemes), std::end(schemes), scheme.name) == std::end(schemes) && !scheme.is_static)
      all.push_back(subject("tet4", false, materials[0], scheme.name));
  return all;
}

Subject subject_of(const sim::Scene& scene) {
  Subject s;
  s.built_in = false;
  s.scene = scene;
  s.element = scene.bodies.front().name;
  s.material = scene.bodies.front().materials.front().model;
  s.scheme = scene.time.integrator;
  s.scene.world.gravity = {0, 0, 0};
  s.scene.obstacles.clear();
  s.scene.springs.clear();
  s.scene.probes.clear();
  for (sim::Body& body : s.scene.bodies) {
    body.pins.clear();
    body.tractions.clear();
    body.velocity.setZero();
    body.spin = {};
    body.start = {};
  }
  return s;
}

}  // namespace app
