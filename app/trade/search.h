// Measures a scene from what matters most to what matters least, as far as the time allows: the time axis on the
// scene's mesh, then meshes, then what is left around the best.
#pragma once

#include <string>
#include <vector>

#include "app/trade/goal.h"
#include "app/trade/lists.h"
#include "app/trade/notebook.h"
#include "app/trade/plan.h"
#include "app/trade/score.h"

namespace app {

class Search {
 public:
  // `comparison`: its stretch is settled by the plan.
  Search(Comparison& comparison, Notebook& notebook, Scorer& scorer, const Goal& goal, std::filesystem::path folder);

  // With a plan given, nothing is chosen by the clock.
  void go(const std::optional<Plan>& plan);

  const Plan& plan() const { return plan_; }
  // What the user should know about the result.
  const std::vector<std::string>& notes() const { return notes_; }

  // Every run that has been scored.
  std::vector<const Score*> scores();

 private:
  void make_plan();
  bool find_references();
  void judge_references(const std::vector<const CaseRun*>& runs);
  void time_axis();
  void raise_floor();
  void mesh_axis();
  const CaseRun* find_finest(std::vector<MeshChange>& changes, double seconds);
  void judge_meshes(const CaseRun& finest);
  void combine();
  void rest();
  void time_front_again();
  void note(const std::string& text);
  const Document& scene() const { return comparison_.scene.document; }

  Comparison& comparison_;
  Notebook& notebook_;
  Scorer& scorer_;
  Goal goal_;
  std::filesystem::path folder_;
  Plan plan_;
  References references_;
  std::vector<std::string> notes_;
};

// The settings that all runs of a mesh study have in common.
TradeCase mesh_time_case(const Document& scene, const Plan& plan);

// All cases of a trade that need no other case's result: what --jobs lists.
std::vector<TradeCase> independent_cases(const Document& scene, const Plan& plan, bool keep_mesh);

}  // namespace app
