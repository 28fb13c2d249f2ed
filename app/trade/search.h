// Measures a scene from what matters most to what matters least, as far as the time allows: the time axis on the
// scene's mesh, then meshes, then what is left around the best.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/trade/lists.h"
#include "app/trade/measurement.h"
#include "app/trade/plan.h"

namespace app {

class Search {
 public:
  explicit Search(Measurement& measurement, std::filesystem::path folder)
      : m_(measurement), folder_(std::move(folder)) {}

  // With a plan given, nothing is chosen by the clock: every scheme is run with every step of the ladder. Without one a
  // goal that names a number is gone for directly.
  void go(const std::optional<Plan>& plan);

  const Plan& plan() const { return plan_; }

 private:
  void make_plan();
  bool time_axis();
  bool ladder();
  bool aimed();
  void tell_what_is_below();
  void rest();
  void calibrate();

  Measurement& m_;
  std::filesystem::path folder_;
  Plan plan_;
  TradeCase mesh_time_;  // scheme and step of the mesh study
};

// All cases of a trade that need no other case's result: what --jobs lists.
std::vector<TradeCase> independent_cases(const Document& scene, const Plan& plan, bool keep_mesh);

}  // namespace app
