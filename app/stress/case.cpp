#include "app/stress/case.h"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "app/stress/extremes.h"
#include "sim/element/element.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

bool is_sheet(const Subject& subject) {
  const sim::Mesh& mesh = subject.scene.bodies.front().mesh;
  return sim::info(mesh.kind).dimension < mesh.dimension();
}

// Mirroring a sheet is a rotation; J of a sheet is never negative; in the plane a line is what the plane is in space.
bool has_meaning(const Subject& subject, const Extreme& extreme) {
  if (is_sheet(subject)) return extreme.name != "mirrored" && extreme.name != "inverted";
  if (subject.scene.dimension == 2) return !extreme.name.starts_with("line");
  return true;
}

// The matrix is full for the starts; steps, materials, meshes and scripts are tried on tets with the three materials
// and schemes that are to hold.
bool is_in_matrix(const Subject& subject, const Extreme& extreme) {
  if (!subject.built_in || extreme.group == "start") return true;
  const auto is_one_of = [](const std::string& name, auto... names) { return ((name == names) || ...); };
  if (!is_one_of(subject.scheme, "backward-euler", "sdirk2", "tr-bdf2")) return false;
  if (extreme.group == "mesh" && subject.scheme == "backward-euler")
    return is_one_of(subject.material, "stable-neo-hookean", "fixed-corotated", "corotated");
  return subject.element == "tet4" && is_one_of(subject.material, "stable-neo-hookean", "fixed-corotated", "corotated");
}

bool is_quick(const Subject& subject, const Extreme& extreme) {
  return extreme.quick && (extreme.group == "start" || !subject.built_in || subject.scheme == "backward-euler");
}

// Long enough to come to rest, short enough to be run. Patient: what is folded may creep for long.
std::int64_t step_count(const sim::Scene& scene, bool patient) {
  constexpr std::int64_t least = 100;
  const double seconds = patient ? 30 : 5;
  const std::int64_t most = patient ? 2000 : 1000;
  const int substeps = std::max(1, scene.time.substeps);
  const double h = double(scene.time.unit) / (double(scene.time.fps) * substeps);
  return std::clamp<std::int64_t>(std::llround(seconds / h), least, most);
}

}  // namespace

std::string StabilityCase::name() const {
  return extreme->group + "/" + extreme->name + " " + subject->element + " " + subject->material + " " +
         subject->scheme;
}

sim::Scene StabilityCase::scene() const {
  sim::Scene scene = subject->scene;
  scene.seed = seed;
  extreme->change(scene);
  return scene;
}

std::vector<Extreme> extremes() {
  std::vector<Extreme> all;
  for (const auto group :
       {start_extremes, untangle_extremes, step_extremes, material_extremes, mesh_extremes, script_extremes})
    for (Extreme& extreme : group()) all.push_back(std::move(extreme));
  return all;
}

std::vector<StabilityCase> make_cases(const std::vector<Subject>& subjects, const std::vector<Extreme>& extremes,
                                      const Choice& choice) {
  std::vector<StabilityCase> cases;
  for (const Extreme& extreme : extremes)
    for (const Subject& subject : subjects) {
      StabilityCase c{&subject, &extreme, choice.seed, 0};
      if (!has_meaning(subject, extreme) || !is_in_matrix(subject, extreme)) continue;
      if (choice.quick && !is_quick(subject, extreme)) continue;
      if (!choice.only.empty() && fnmatch(("*" + choice.only + "*").c_str(), c.name().c_str(), 0) != 0) continue;
      c.steps = step_count(c.scene(), extreme.group == "start" && !choice.quick) * (extreme.loaded ? 4 : 1);
      for (int k = 0; k < choice.seeds; ++k, ++c.seed) cases.push_back(c);
    }
  return cases;
}

}  // namespace app
