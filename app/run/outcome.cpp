#include "app/run/outcome.h"

#include <algorithm>
#include <iostream>

#include "app/base/exit_code.h"
#include "app/base/text.h"

namespace app {
namespace {

std::string why(const Simulation& simulation, const Outcome& outcome) {
  return outcome.failure.failure.empty() ? outcome.error : failure_text(*simulation.system, outcome.failure);
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
      std::cout << formatted("%s.u%c = %.6g m, reference %.6g m, error %.3g %%\n",
                             document.scene.probes[k].name.c_str(), "xyz"[c], is[c], should[c],
                             100 * (is[c] / should[c] - 1));
    }
  }
}

// What did not go smoothly, though the run went on.
void print_trouble(const Outcome& outcome) {
  const Totals& totals = outcome.run.totals;
  const std::int64_t steps = outcome.run.state.step;
  if (totals.not_converged > 0) {
    std::cerr << "note: " << totals.not_converged << " of " << steps << " steps did not converge";
    if (!outcome.not_converged_reason.empty()) std::cerr << " (" << outcome.not_converged_reason << ')';
    std::cerr << '\n';
  }
  if (totals.splits > 0)
    std::cerr << "note: steps, or parts of them, were taken again in halves " << totals.splits << " times\n";
  if (outcome.braked > 0)
    std::cerr << "note: " << outcome.braked
              << " steps would have given energy to bodies that nothing drives: taken so that they do not\n";
  if (!outcome.overlap.empty())
    std::cerr << "note: " << outcome.overlap << ": no [[contact]] names them, which would keep them apart\n";
  if (outcome.inverted > 0) std::cerr << "note: " << outcome.inverted << " elements are inside out at the end\n";
  if (outcome.no_factor)
    std::cerr << "note: there was no memory for the matrix's factor: solved by conjugate gradients without a matrix\n";
}

}  // namespace

bool Outcome::add(const sim::StepReport& report) {
  braked += report.braked;
  stepping += report.seconds;
  assembling += report.seconds_assemble;
  solving += report.seconds_solve;
  if (!report.failure.empty()) {
    failure = report;
    return false;
  }
  Totals& totals = run.totals;
  totals.newton += report.newton;
  totals.linear += report.linear;
  totals.not_converged += report.converged ? 0 : 1;
  totals.splits += report.splits;
  totals.min_J = std::min(totals.min_J, report.min_J);
  inverted = report.inverted;
  if (!report.converged && not_converged_reason.empty()) not_converged_reason = report.reason;
  no_factor = no_factor || report.no_factor;
  return true;
}

int conclude(const Simulation& simulation, const Options& options, const RunFolder& folder, const Outcome& outcome) {
  if (!options.quiet) print_trouble(outcome);
  if (outcome.status == Status::done) {
    print_references(simulation, outcome);
    return exit_done;
  }
  const std::string saved = folder.state().string();
  if (outcome.status == Status::interrupted) {
    std::cerr << "ritz: interrupted after step " << outcome.run.state.step << " of " << simulation.last_step()
              << "; go on with --resume " << folder.path().string() << '\n';
    return exit_interrupted;
  }
  std::cerr << "ritz: " << why(simulation, outcome) << "\n      the last good state is saved in " << saved << '\n';
  return exit_numerical_failure;
}

}  // namespace app
