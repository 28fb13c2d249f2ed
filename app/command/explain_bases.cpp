#include "app/command/explain_bases.h"

#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/base/text.h"
#include "app/scene/basis_cache.h"
#include "app/scene/snapshots.h"
#include "sim/study/basis.h"
#include "sim/study/projection.h"

namespace app {
namespace {

constexpr int most_unknowns = 150000;  // of a full body that is solved before a step is taken

void print_projection(const sim::System& system, const char* what, const Eigen::MatrixXd& u) {
  const std::optional<double> error = u.cols() > 0 ? sim::projection_error(system, u) : std::nullopt;
  std::cout << "  " << what << ": "
            << (error
                    ? formatted("%.6g %% of its squared mass norm can be represented, %.2g %% of the norm is left out",
                                100 * (1 - *error * *error), 100 * *error)
                    : std::string("nothing is displaced, or it has no solution"))
            << '\n';
}

// Displacements of all bodies at the frames of a run.
Eigen::MatrixXd displacements(const std::filesystem::path& run, const sim::Scene& scene, const sim::System& system) {
  Eigen::MatrixXd u;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto own = read_snapshots(run, scene, b);
    if (b == 0) u.setZero(system.initial_state().x.size(), own->cols());
    u.middleRows(Eigen::Index{scene.dimension} * system.bodies()[b].first_node, own->rows()) = *own;
  }
  return u;
}

void print_comparison(const Simulation& simulation, const Options& options) {
  const sim::System& system = *simulation.system;
  const std::vector<std::int64_t> frames = snapshot_frames(options.compare);
  std::vector<std::int64_t> steps;
  for (const std::int64_t frame : frames) steps.push_back(frame * system.steps_per_frame());
  const Eigen::MatrixXd u = displacements(options.compare, simulation.document.scene, system);
  const sim::Compared compared = sim::compare(system, steps, u, options.threads);
  std::cout << "  " << options.compare.string() << ", " << frames.size()
            << " states to t = " << formatted("%.4g", system.time(steps.back())) << " s: ";
  if (!compared.failure.empty()) {
    std::cout << "the run in the basis ends at " << compared.failure << '\n';
    return;
  }
  std::cout << "the basis can come to " << percent(compared.best) << " of the body's size (rms), its run comes to "
            << percent(compared.made) << ", " << percent(compared.most) << " at most\n";
}

}  // namespace

void print_bases(const Simulation& simulation, const Options& options) {
  const sim::Scene& scene = simulation.document.scene;
  if (!sim::has_basis(scene)) {
    if (!options.compare.empty()) throw std::runtime_error("--compare is for scenes with a basis, and no body has one");
    return;
  }
  std::cout << "basis\n  vectors and training: " << formatted("%.2g s", simulation.basis_seconds);
  if (!options.cache.empty()) std::cout << ", kept in " << basis_file(options.cache, simulation.document).string();
  std::cout << '\n';
  if (simulation.system->counts().dofs <= most_unknowns) {
    print_projection(*simulation.system, "static solution", sim::rest_of_full(scene, options.threads));
    print_projection(*simulation.system, "first swing", sim::swing_of_full(scene, options.threads));
  } else {
    std::cout << "  too many unknowns to be solved here: --compare puts a run beside it\n";
  }
  if (!options.compare.empty()) print_comparison(simulation, options);
}

}  // namespace app
