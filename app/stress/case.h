// The matrix of stability, `ritz stress`: subjects (a body with its material, scheme and solver) times extremes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/stress/body.h"
#include "sim/scene.h"

namespace app {

// A free body at rest; no gravity, no loads.
struct Subject {
  std::string body, material, scheme;
  sim::Scene scene;
  Part part = Part::own;
};

struct Extreme {
  std::string group, name;  // "start", "scrambled"
  bool quick = false;       // part of --quick
  bool loaded = false;      // ends under loads, not at the rest shape
  std::function<void(sim::Scene&)> change;

  // Forces have a potential and nothing is driven: energy must not grow.
  bool keeps_energy() const { return group == "obstacle" || group == "contact" || group == "start"; }
  // Goes on, with longer steps, until the body is at rest: what is folded creeps, and what is slender unbends slowly.
  bool is_patient() const { return group == "start" || group == "untangle"; }
};

// One run.
struct StabilityCase {
  const Subject* subject;
  const Extreme* extreme;
  std::uint64_t seed;
  std::int64_t steps;

  // "start/scrambled tet4 stable-neo-hookean backward-euler": what --only is compared with
  std::string name() const;
  sim::Scene scene() const;
};

// Throws std::runtime_error where the meshes that come with the program are not found.
std::vector<Subject> built_in_subjects(bool quick);
// The bodies of a scene with their materials, its time step, scheme and solver; without gravity, loads, pins, bases,
// obstacles and contact, which no start that folds a body allows.
Subject subject_of(const sim::Scene& scene);

// Steps of an implicit scheme become a minute where they were a second: what creeps is followed until it is at rest.
// False: the scheme is explicit.
bool slow_down(sim::Scene& scene);

// All extremes, in the order of the table.
std::vector<Extreme> extremes();

// Which of the matrix is run.
struct Choice {
  bool quick = false;
  std::string only;        // a pattern with * and ?, found anywhere in the name; empty: all
  std::uint64_t seed = 1;  // of the first run of each case
  int seeds = 1;           // runs of each case in which anything is random, with seeds one after the other
};

// Every combination that means something and is chosen. Subjects and extremes must outlive the cases.
std::vector<StabilityCase> make_cases(const std::vector<Subject>& subjects, const std::vector<Extreme>& extremes,
                                      const Choice& choice);

}  // namespace app
