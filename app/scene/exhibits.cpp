#include "app/scene/exhibits.h"

#include <algorithm>

namespace app {

// Each in a file of its own in app/exhibit.
std::unique_ptr<Exhibit> make_pipeline(const ExhibitInput&);
std::unique_ptr<Exhibit> make_shape_functions(const ExhibitInput&);
std::unique_ptr<Exhibit> make_interpolation(const ExhibitInput&);
std::unique_ptr<Exhibit> make_five_vectors(const ExhibitInput&);
std::unique_ptr<Exhibit> make_weighted_residuals(const ExhibitInput&);
std::unique_ptr<Exhibit> make_self_adjoint(const ExhibitInput&);
std::unique_ptr<Exhibit> make_forces_and_energies(const ExhibitInput&);
std::unique_ptr<Exhibit> make_bar_clocks(const ExhibitInput&);
std::unique_ptr<Exhibit> make_xray(const ExhibitInput&);
std::unique_ptr<Exhibit> make_force_steps(const ExhibitInput&);
std::unique_ptr<Exhibit> make_step_limit(const ExhibitInput&);
std::unique_ptr<Exhibit> make_definiteness(const ExhibitInput&);
std::unique_ptr<Exhibit> make_momentum(const ExhibitInput&);
std::unique_ptr<Exhibit> make_ring_down(const ExhibitInput&);
std::unique_ptr<Exhibit> make_reduced_basis(const ExhibitInput&);

std::span<const ExhibitKind> exhibit_kinds() {
  static const std::vector<ExhibitKind> table = {
      {"pipeline", "positions, F, P and forces, one after the other", {"body", "element", "pace"}, make_pipeline},
      {"shape-functions",
       "hills over the mesh, and their sum",
       {"body", "node", "pace", "values"},
       make_shape_functions},
      {"interpolation", "a function, its interpolants and the order", {"basis", "count", "pace"}, make_interpolation},
      {"five-vectors",
       "a large system in a few vectors, by four methods",
       {"basis", "count", "rows", "values", "method", "wind", "pace"},
       make_five_vectors},
      {"weighted-residuals",
       "a differential equation in a few functions: solution, residual, errors",
       {"problem", "basis", "count", "method", "values", "pace"},
       make_weighted_residuals},
      {"self-adjoint",
       "advection and diffusion: where Ritz's method does not apply",
       {"eps", "count", "anyway", "pace"},
       make_self_adjoint},
      {"forces-and-energies", "forces beside the slope of U; T and U", {"body"}, make_forces_and_energies},
      {"bar-clocks", "lumped and consistent mass: frequencies and phases", {"count"}, make_bar_clocks},
      {"x-ray", "one triangle: F, stretches, P, forces", {"body", "element", "nodes"}, make_xray},
      {"force-steps", "the force algorithm in sub-steps", {"body", "pace"}, make_force_steps},
      {"step-limit",
       "growth below and above the explicit limit, K's pattern",
       {"body", "element", "pace", "values"},
       make_step_limit},
      {"definiteness", "eigenvalues and three paths of Newton", {"body", "nodes", "pace"}, make_definiteness},
      {"momentum", "what free bodies keep of their momentum", {}, make_momentum},
      {"ring-down", "a mode that is damped", {"body"}, make_ring_down},
      {"reduced-basis", "a body in all of its nodes and in r numbers", {"body", "pace", "values"}, make_reduced_basis},
  };
  return table;
}

const ExhibitKind* find_exhibit_kind(std::string_view name) {
  const auto found = std::ranges::find(exhibit_kinds(), name, &ExhibitKind::name);
  return found == exhibit_kinds().end() ? nullptr : &*found;
}

bool exhibit_has(std::string_view kind, std::string_view key) {
  const ExhibitKind* found = find_exhibit_kind(kind);
  return key == "kind" || found == nullptr || std::ranges::find(found->keys, key) != found->keys.end();
}

}  // namespace app
