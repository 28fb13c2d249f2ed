// The bodies that are put to the test, with their materials and schemes.
#include <algorithm>
#include <string_view>

#include "app/stress/case.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

// Stretch waves of a body of this size take 0.2 s; damped so that the slowest bending of a block dies within a second.
Subject subject(const TestBody& test, std::string_view material, std::string_view scheme) {
  Subject s;
  s.body = test.name;
  s.material = material;
  s.scheme = scheme;
  s.part = test.part;
  sim::Body body;
  body.name = "body";
  body.mesh = test.make(test);
  body.thickness = test.thickness;
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

// Three materials and schemes that are to hold at every extreme, and the others.
void add_reference(const TestBody& test, bool quick, std::vector<Subject>& all) {
  for (const std::string_view material : materials)
    for (const std::string_view scheme : schemes)
      if (!quick || material == materials[0] || scheme == schemes[0]) all.push_back(subject(test, material, scheme));
  if (quick) return;
  for (const char* material : {"neo-hookean", "stvk", "linear"}) all.push_back(subject(test, material, schemes[0]));
  for (const sim::Scheme& scheme : sim::schemes())
    if (std::find(std::begin(schemes), std::end(schemes), scheme.name) == std::end(schemes) && !scheme.is_static)
      all.push_back(subject(test, materials[0], scheme.name));
}

}  // namespace

std::vector<Subject> built_in_subjects(bool quick) {
  std::vector<Subject> all;
  for (const TestBody& test : test_bodies()) {
    if (test.part == Part::reference) {
      add_reference(test, quick, all);
      continue;
    }
    if (quick) continue;
    for (const std::string_view material : materials)
      if (test.part == Part::element || material == materials[0]) all.push_back(subject(test, material, schemes[0]));
  }
  return all;
}

Subject subject_of(const sim::Scene& scene) {
  Subject s;
  s.scene = scene;
  s.body = scene.bodies.front().name;
  s.material = scene.bodies.front().materials.front().model;
  s.scheme = scene.time.integrator;
  s.scene.world.gravity = {0, 0, 0};
  s.scene.obstacles.clear();
  s.scene.contacts.clear();
  s.scene.springs.clear();
  s.scene.probes.clear();
  for (sim::Body& body : s.scene.bodies) {
    body.pins.clear();
    body.loads = {};
    body.velocity.setZero();
    body.spin = {};
    body.start = {};
    body.basis.reset();  // it was made for what the pins hold
  }
  return s;
}

}  // namespace app
