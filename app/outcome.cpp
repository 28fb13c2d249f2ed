#include "app/outcome.h"

#include <cstdio>
#include <iostream>

#include "app/commands.h"

namespace app {
namespace {

// Where and why a step failed: "step 12 (t = 0.2 s), element 7: ...".
std::string failure_text(const Simulation& simulation, const Outcome& outcome) {
  if (outcome.failure.failure.empty()) return outcome.error;
  const std::int64_t step = outcome.run.state.step + 1;
  char where[80];
  std::snprintf(where, sizeof where, "step %lld (t = %.6g s)", static_cast<long long>(step),
                simulation.system->time(step));
  std::string text = where;
  if (outcome.failure.min_J_element >= 0) text += ", element " + std::to_string(outcome.failure.min_J_element);
  return text + ": " + outcome.failure.failure;
}

// Probes that know what they should show: value, reference and error.
void print_references(const Simulation& simulation, const Outcome& outcome) {
  const Document& document = simulation.document;
  for (std::size_t k = 0; k < document.references.size(); ++k) {
    if (!document.references[k]) continue;
    const Vec3 is = simulation.system->probe_displacement(outcome.run.state, static_cast<int>(k)),
               should = *document.references[k];
    for (int c = 0; c < simulation.system->dimension(); ++c) {
      if (should[c] == 0) continue;
      char line[160];
      std::snprintf(line, sizeof line, "%s.u%c = %.6g m, reference %.6g m, error %.3g %%\n",
                    document.scene.probes[k].name.c_str(), "xyz"[c], is[c], should[c], 100 * (is[c] / should[c] - 1));
      std::cout << line;
    }
  }
}

}  // namespace

int conclude(const Simulation& simulation, const Options& options, const RunFolder& folder, const Outcome& outcome) {
  const std::int64_t not_converged = outcome.run.totals.not_converged;
  if (not_converged > 0 && !options.quiet) {
    std::cerr << "note: " << not_converged << " of " << outcome.run.state.step
              << " steps did not converge (solver.max_iterations reached)\n";
  }
  if (outcome.status == Status::done) {
    print_references(simulation, outcome);
    return kDone;
  }
  const std::string saved = folder.state().string();
  if (outcome.status == Status::interrupted) {
    std::cerr << "ritz: interrupted after step " << outcome.run.state.step << " of " << simulation.last_step()
              << "; go on with --resume " << folder.path().string() << '\n';
    return kInterrupted;
  }
  std::cerr << "ritz: " << failure_text(simulation, outcome) << "\n      the last good state is saved in " << saved
            << '\n';
  return kNumericalFailure;
}

}  // namespace app
