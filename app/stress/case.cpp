#include "app/stress/case.h"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "app/stress/extremes.h"
#include "sim/body/start.h"
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

// The matrix is full for the scenes of users and for bodies whose shape is what they are there for. Every scheme that
// can meets obstacles and other bodies; starts are tried with every material, scheme and element, the other extremes
// with the three materials and schemes that are to hold.
bool is_in_matrix(const Subject& subject, const Extreme& extreme) {
  const auto is_one_of = [](const std::string& name, auto... names) { return ((name == names) || ...); };
  const bool holds = is_one_of(subject.material, "stable-neo-hookean", "fixed-corotated", "corotated") &&
                     is_one_of(subject.scheme, "backward-euler", "sdirk2", "tr-bdf2");
  switch (subject.part) {
    case Part::own:
    case Part::shape:
      return true;
    case Part::beam:
      return extreme.group == "bending";
    case Part::element:
      return is_one_of(extreme.group, "start", "mesh");
    case Part::reference:
      if (is_one_of(extreme.group, "obstacle", "contact"))
        return subject.material == "stable-neo-hookean" && sim::find_scheme(subject.scheme)->heeds_barriers();
      return extreme.group == "start" || (holds && extreme.group != "bending");
  }
  return false;
}

bool is_quick(const Subject& subject, const Extreme& extreme) {
  return extreme.quick && (extreme.group == "start" || subject.part == Part::own || subject.scheme == "backward-euler");
}

// Whether another seed makes another case: it settles where bodies start, and nothing else is random.
bool is_random(const sim::Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const sim::Body& body) {
    const auto from = [&](std::uint64_t seed) {
      return sim::start_positions(body.mesh, body.start, scene.dimension, seed);
    };
    return from(scene.seed) != from(scene.seed + 1);
  });
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
  return extreme->group + "/" + extreme->name + " " + subject->body + " " + subject->material + " " + subject->scheme;
}

sim::Scene StabilityCase::scene() const {
  sim::Scene scene = subject->scene;
  scene.seed = seed;
  extreme->change(scene);
  return scene;
}

bool slow_down(sim::Scene& scene) {
  if (sim::find_scheme(scene.time.integrator)->is_explicit()) return false;
  set_step(scene, 60 * double(scene.time.unit) / (double(scene.time.fps) * std::max(1, scene.time.substeps)));
  return true;
}

std::vector<Extreme> extremes() {
  std::vector<Extreme> all;
  for (const auto group : {start_extremes, untangle_extremes, step_extremes, material_extremes, mesh_extremes,
                           script_extremes, obstacle_extremes, contact_extremes, bending_extremes})
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
      const bool falls_far = extreme.group == "script" && extreme.loaded;
      c.steps = step_count(c.scene(), extreme.group == "start" && !choice.quick) * (falls_far ? 4 : 1);
      const int seeds = choice.seeds > 1 && is_random(c.scene()) ? choice.seeds : 1;
      for (int k = 0; k < seeds; ++k, ++c.seed) cases.push_back(c);
    }
  return cases;
}

}  // namespace app
