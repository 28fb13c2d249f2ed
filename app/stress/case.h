// The matrix of `ritz stress`: subjects (a body with its material, scheme and solver) times extremes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/scene.h"

namespace app {

// A free body at rest; no gravity, no loads.
struct Subject {
  std::string element, material, scheme;
  sim::Scene scene;
  bool built_in = true;  // not from a scene of the user
};

struct Extreme {
  std::string group, name;  // "start", "scrambled"
  bool quick = false;       // part of --quick
  bool loaded = false;      // ends under loads, not at the rest shape
  std::function<void(sim::Scene&)> change;
};

// One run.
struct Case {
  const Subject* subject;
  const Extreme* extreme;
  std::int64_t steps;

  // "start/scrambled tet4 stable-neo-hookean backward-euler": what --only is compared with
  std::string name() const;
  sim::Scene scene(std::uint64_t seed) const;
};

std::vector<Subject> built_in_subjects(bool quick);
// The bodies of a scene with their materials, its time step, scheme and solver; without gravity, loads, pins and
// obstacles.
Subject subject_of(const sim::Scene& scene);

// All extremes, in the order of the table.
std::vector<Extreme> extremes();

// What is run: every combination that means something; `only` (a pattern with * and ?, found anywhere) thins it out.
// Subjects and extremes must outlive the cases.
std::vector<Case> make_cases(const std::vector<Subject>& subjects, const std::vector<Extreme>& extremes, bool quick,
                             const std::string& only);

}  // namespace app
