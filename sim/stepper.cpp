#include "sim/stepper.h"

#include <algorithm>
#include <utility>

#include "sim/build/parts.h"
#include "sim/reduce/reduced_stepper.h"
#include "sim/time/explicit.h"
#include "sim/time/implicit.h"

namespace sim {
namespace {

// Statics of what nothing holds: every step fails, and says why.
class Unheld final : public Stepper {
 public:
  explicit Unheld(std::string why) : why_(std::move(why)) {}
  StepReport step(State& state) override {
    StepReport report;
    report.step = state.step + 1;
    report.failure = why_;
    return report;
  }

 private:
  std::string why_;
};

}  // namespace

std::unique_ptr<Stepper> make_stepper(const System& system, int threads, std::function<bool()> interrupted) {
  const Parts& parts = parts_of(system);
  if (!parts.no_equilibrium.empty()) return std::make_unique<Unheld>(parts.no_equilibrium);
  if (parts.reduction) return std::make_unique<ReducedStepper>(parts.model, *parts.reduction, *parts.scheme, threads);
  if (parts.scheme->is_explicit()) return std::make_unique<ExplicitStepper>(parts.model, *parts.scheme, threads);
  return std::make_unique<ImplicitStepper>(parts.model, *parts.scheme, threads, std::move(interrupted));
}

// Measured by `ritz run` on 2 cores, seconds on one thread over those on two: the bear of 4,500 degrees of freedom 0.5,
// beam-cost.toml of 8,000 1.0, of 25,000 1.15, of 57,000 1.3.
int useful_threads(const System& system, int threads) {
  constexpr Eigen::Index dofs_each = 10000;
  const Parts& parts = parts_of(system);
  const bool sampled = parts.reduction && parts.reduction->sample;
  const Eigen::Index dofs = sampled ? parts.reduction->sample->lift->dofs() : parts.model.dofs();
  return static_cast<int>(std::clamp<Eigen::Index>(dofs / dofs_each, 1, threads));
}

}  // namespace sim
