// How accurate the runs of a trade are: time, mesh and model errors apart, and their total.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "app/trade/comparison.h"
#include "app/trade/costs.h"
#include "app/trade/goal.h"
#include "sim/study/reference_check.h"

namespace app {

// Distance of two runs over the frames before the horizon.
struct Apart {
  double rms = 0, max = 0;  // shares of the body's size
  double pixels = 0;        // rms at 1080p
};

// What runs are measured against.
struct References {
  const CaseRun* time = nullptr;  // on the scene's mesh; none: no error is known
  sim::ReferenceCheck check;
  Apart uncertainty;              // of the time error
  const CaseRun* mesh = nullptr;  // on the finest mesh; none: no mesh error is known
  TradeCase mesh_time;            // scheme and step of all runs of which mesh errors are taken
  Apart total_uncertainty;        // of the total error: time error of the mesh reference, and its own mesh error
};

// An error that is less than this many uncertainties of the reference is not told from zero.
inline constexpr double told_apart = 2;

struct Score {
  const CaseRun* run = nullptr;
  std::optional<Apart> time;   // against the reference of the scene's mesh: only time and solver settings differ
  std::optional<Apart> mesh;   // against the finest mesh, with the same scheme and step
  std::optional<Apart> model;  // another material than the scene's, against the reference of the scene's mesh
  std::optional<Apart> total;  // against the finest mesh
  double energy_drift = 0, momentum_drift = 0;  // where the mesh is the scene's
  double centre = 0, mean_energy = 0;           // centre of mass, energy on average: statistics for chaotic scenes
  bool below = false;                           // the error on the scene's mesh is not told from zero
  bool resolved = false;  // it is ten times the reference's uncertainty or more: enough to see an order

  // What is certain of the error of the run: the largest of total, time and model error (a total that is smaller than
  // one of its parts is luck), with the uncertainty of the reference. Infinite where nothing is known.
  Apart bound;
  double seconds = 0;  // wall, per simulated second, by itself: what runs are ranked by
};

class Scorer {
 public:
  explicit Scorer(const Comparison& comparison) : comparison_(comparison), screen_(screen_points(comparison)) {}

  // From now on runs are measured against these, and cost so much.
  void set(const References& references);
  void set(const Costs& costs);
  const References& references() const { return references_; }
  Apart apart(const CaseRun& a, const CaseRun& b) const;
  // The score of a run is kept under the run's address, which must not change.
  const Score& score(const CaseRun& run);
  Score judge(const CaseRun& run) const;

 private:
  void judge_against_time(Score& score) const;
  void judge_against_mesh(Score& score) const;

  const Comparison& comparison_;
  sim::SamplePoints screen_;
  References references_;
  Costs costs_;
  std::map<const CaseRun*, Score> known_;
};

// The error that a goal is about.
double error_of(const Apart& apart, const Goal& goal);

}  // namespace app
