// A case: the scene with some keys changed; and what running it has shown.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/options/options.h"
#include "sim/study/trajectory.h"
#include "sim/study/unit_costs.h"

namespace app {

enum class Axis { scene, reference, time, mesh, rest, advice };

// "scene", "reference", ...
std::string_view axis_name(Axis axis);

// The one setting that is no key of the scene.
inline constexpr const char* thread_option = "--threads";

struct TradeCase {
  std::string label;  // "tr-bdf2 h=1/120"
  Axis axis = Axis::time;
  std::vector<std::pair<std::string, std::string>> settings;  // key, value: laid over the scene
};

// The scene as it is.
TradeCase scene_case();

// The options of the scene with the case's settings over them.
Options options_of(const Options& scene, const TradeCase& which);

// "time.integrator=tr-bdf2;time.substeps=2"
std::string settings_text(const TradeCase& which);

// The case with one more setting, which replaces one of the same key.
TradeCase with(TradeCase which, const std::string& label, const std::string& key, const std::string& value);

// Work per simulated second.
struct Work {
  std::vector<double> seconds;  // wall, stepping only, the first step of a run left out: one for each timed run
  double cpu = 0;               // CPU seconds of all threads, the least of these runs
  double steps = 0, newton = 0, force_evaluations = 0, factorisations = 0, linear = 0;

  sim::StepCounts counts() const { return {steps, force_evaluations, factorisations, linear}; }

  double median() const;
  double least() const;
};

enum class CaseStatus { done, failed, skipped };

struct CaseRun {
  TradeCase which;
  std::uint64_t id = 0;  // of the scene with these settings, the frames compared and the program's version
  CaseStatus status = CaseStatus::skipped;
  std::string reason;    // why it failed or was skipped
  double estimate = 0;   // s: what a run that was given up would have taken
  sim::Trajectory path;  // of the scene's own nodes
  Work work;
  std::vector<sim::TimedStep> timed;  // some of its steps, all along it
  double training = 0;                // s that making its bases took, once, before the first step
  double step = 0;                    // s, h
  int order = 0;                      // of the integrator
  std::int64_t dofs = 0;
  std::int64_t not_converged = 0;  // steps
};

}  // namespace app
