// The lists of cases that a trade may try.
#pragma once

#include <vector>

#include "app/scene/document.h"
#include "app/trade/case.h"
#include "sim/system.h"

namespace app {

// The two runs of the reference scheme, with `fine` steps a frame and half of them, and the two of the scheme that
// checks it, with a half and a quarter; tight tolerance. In the order of sim::ReferenceRuns. fine: 4, 8, 16, ...
std::vector<TradeCase> reference_cases(const Document& scene, int fine);

// One case: integrator with `substeps` steps a frame.
TradeCase time_case(const Document& scene, std::string_view integrator, int substeps);

// One of the first and one of the second order, then all others that the scene allows.
std::vector<std::string> implicit_schemes(const Document& scene);
// Those that its contacts and obstacles do not allow, explicit ones as well; separated by commas.
std::string schemes_that_do_not_serve(const Document& scene);

// Each of them with 1, 2, 4, ... depth steps a frame.
std::vector<TradeCase> time_cases(const Document& scene, int depth);

// The explicit schemes that the scene allows, with the steps that stability needs.
std::vector<TradeCase> explicit_cases(const Document& scene);

// A mesh other than the scene's, and how many times more numbers it has, about.
struct MeshChange {
  TradeCase change;  // only the keys of the mesh
  double growth;     // of the unknowns
  bool finest;       // fine enough to measure the others against: quadratic, and finer than the scene's
};

// Coarser and finer meshes, linear, quadratic and of bricks where the scene's meshes can be made so.
std::vector<MeshChange> mesh_changes(const Document& scene);

// The case in all nodes, where bodies have a basis: what that cannot reach is part of its error.
TradeCase in_all_nodes(const Document& scene, const TradeCase& around);

// One setting changed at a time: tolerance, linear solver, definiteness, contact distance, lag of friction and damping,
// mass, material, kind and count of a basis. What the scene lacks is not tried.
std::vector<TradeCase> rest_cases(const Document& scene, const TradeCase& around);

// The case on other numbers of threads than those that are given; none where the system has no use for them.
std::vector<TradeCase> thread_cases(const sim::System& system, int given, const TradeCase& around);

// The settings of `a`, then those of `b` over them.
TradeCase both(const TradeCase& a, const TradeCase& b, Axis axis);

}  // namespace app
