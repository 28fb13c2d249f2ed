#include "app/trade/lists.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "app/base/text.h"
#include "sim/build/barrier_scheme.h"
#include "sim/element/element.h"
#include "sim/stepper.h"
#include "sim/study/basis.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

constexpr const char* tight = "1e-6";  // body sizes/s

std::string step_text(const Document& scene, int substeps) {
  return "h=1/" + std::to_string(scene.scene.time.fps * substeps);
}

// Whether a step freezes something at its start, which costs an order of accuracy: solver.lag_iterations.
bool lags(const sim::Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const sim::Body& body) { return body.damping.beta > 0; }) ||
         std::ranges::any_of(scene.obstacles, [](const sim::Obstacle& obstacle) { return obstacle.friction > 0; }) ||
         std::ranges::any_of(scene.contacts, [](const sim::Contact& contact) { return contact.friction > 0; });
}

TradeCase lagging(const TradeCase& which, const std::string& iterations) {
  return with(which, "lag " + iterations, "solver.lag_iterations", iterations);
}

// All bodies with a basis of this kind, and as many vectors.
TradeCase in_basis(const Document& scene, const TradeCase& around, const std::string& kind, const std::string& count) {
  TradeCase which = around;
  for (std::size_t b = 0; b < scene.scene.bodies.size(); ++b) {
    const std::string basis = "body." + std::to_string(b) + ".basis.";
    which = with(which, "", basis + "kind", kind);
    if (!count.empty()) which = with(which, "", basis + "count", count);
  }
  return which;
}

TradeCase reference_case(const Document& scene, std::string_view integrator, int substeps) {
  TradeCase which = time_case(scene, integrator, substeps);
  which.axis = Axis::reference;
  which = with(which, "tolerance 1e-6", "solver.tolerance", tight);
  if (scene.scene.solver.linear != sim::LinearSolverKind::automatic)
    which = with(which, "auto", "solver.linear", "auto");
  which = in_all_nodes(scene, which);
  return lags(scene.scene) ? lagging(which, "1") : which;
}

bool is_number(const std::string& text, double value) {
  return std::abs(std::stod(text) / value - 1) < 1e-9;
}

// What the case sets the key to, or what the scene has.
std::string setting(const TradeCase& which, const std::string& key, const std::string& of_scene) {
  for (const auto& [name, value] : which.settings)
    if (name == key) return value;
  return of_scene;
}

// Every other value of an enum of sim/choices.h.
template <class E>
void add_choices(const std::string& label, const std::string& key, E of_scene, const TradeCase& around,
                 std::vector<TradeCase>& list) {
  const std::string is = setting(around, key, std::string(name_of(of_scene)));
  for (const sim::Choice<E>& choice : sim::choices<E>)
    if (choice.name != is)
      list.push_back(with(around, label + std::string(choice.name), key, std::string(choice.name)));
}

void add_solver_cases(const sim::Solver& solver, const TradeCase& around, std::vector<TradeCase>& list) {
  const std::string tolerance = setting(around, "solver.tolerance", std::to_string(solver.tolerance));
  for (const char* const value : {"1e-2", "1e-3", "1e-6"})
    if (!is_number(tolerance, std::stod(value)))
      list.push_back(with(around, std::string("tolerance ") + value, "solver.tolerance", value));
  add_choices("", "solver.linear", solver.linear, around, list);
  add_choices("definiteness ", "solver.definiteness", solver.definiteness, around, list);
}

// How often friction and damping are evaluated anew at a stage's solution.
void add_lag_cases(const sim::Solver& solver, const TradeCase& around, std::vector<TradeCase>& list) {
  const std::string is = setting(around, "solver.lag_iterations", std::to_string(solver.lag_iterations));
  for (const char* const iterations : {"0", "1", "2"})
    if (is != iterations) list.push_back(lagging(around, iterations));
}

// One change to every body that it changes at all.
void add_body_case(const Document& scene, const TradeCase& around, const std::string& key, const std::string& value,
                   std::string (*is)(const sim::Body&), std::vector<TradeCase>& list) {
  TradeCase which = around;
  bool changed = false;
  for (std::size_t b = 0; b < scene.scene.bodies.size(); ++b) {
    if (is(scene.scene.bodies[b]) == value) continue;
    which = with(which, "", "body." + std::to_string(b) + "." + key, value);
    changed = true;
  }
  which.label = around.label + ", " + value;
  if (changed) list.push_back(which);
}

// Fewer and more vectors, of the kinds that ask for no run; the scene's own are measured with the rest.
void add_basis_cases(const Document& scene, const TradeCase& around, std::vector<TradeCase>& list) {
  if (!sim::has_basis(scene.scene)) return;
  const sim::Basis& own = *scene.scene.bodies.front().basis;
  for (const char* const kind : {"modes", "derivatives"})
    for (const int count : {5, 10, 20, 40}) {
      if (kind == sim::name_of(own.kind) && count == own.count) continue;
      list.push_back(in_basis(scene, around, kind, std::to_string(count)));
      list.back().label = around.label + ", " + std::to_string(count) + " " + kind;
    }
}

// Where contact begins, of all entries at once: a quarter of the scene's, and four times as much. Where the scene does
// not say, it is a thousandth of the smallest body.
void add_distance_cases(const sim::Scene& scene, const TradeCase& around, std::vector<TradeCase>& list) {
  if (scene.contacts.empty()) return;
  double size = std::numeric_limits<double>::infinity();
  for (const sim::Body& body : scene.bodies)
    size = std::min(size, (body.mesh.X.rowwise().maxCoeff() - body.mesh.X.rowwise().minCoeff()).maxCoeff());
  for (const double factor : {0.25, 4.0}) {
    TradeCase which = around;
    for (std::size_t k = 0; k < scene.contacts.size(); ++k)
      which = with(which, "", "contact." + std::to_string(k) + ".distance",
                   formatted("%.3g", factor * scene.contacts[k].distance.value_or(1e-3 * size)));
    which.label = around.label + formatted(", contact distance x %g", factor);
    list.push_back(which);
  }
}

}  // namespace

TradeCase in_all_nodes(const Document& scene, const TradeCase& around) {
  if (!sim::has_basis(scene.scene)) return around;
  TradeCase which = in_basis(scene, around, "none", "");
  which.label += ", all nodes";
  return which;
}

TradeCase time_case(const Document& scene, std::string_view integrator, int substeps) {
  return {std::string(integrator) + " " + step_text(scene, substeps),
          Axis::time,
          {{"time.integrator", std::string(integrator)}, {"time.substeps", std::to_string(substeps)}}};
}

std::vector<TradeCase> reference_cases(const Document& scene, int fine) {
  return {reference_case(scene, "tr-bdf2", fine), reference_case(scene, "tr-bdf2", fine / 2),
          reference_case(scene, "sdirk2", fine / 2), reference_case(scene, "sdirk2", fine / 4)};
}

std::vector<std::string> implicit_schemes(const Document& scene) {
  std::vector<std::string> names = {"backward-euler", "tr-bdf2"};
  for (const sim::Scheme& scheme : sim::schemes())
    if (!scheme.is_explicit() && !scheme.is_static && sim::serves(scheme, scene.scene) &&
        std::ranges::find(names, scheme.name) == names.end())
      names.emplace_back(scheme.name);
  return names;
}

std::string schemes_that_do_not_serve(const Document& scene) {
  std::string names;
  for (const sim::Scheme& scheme : sim::schemes())
    if (!scheme.is_static && !sim::serves(scheme, scene.scene))
      names += (names.empty() ? "" : ", ") + std::string(scheme.name);
  return names;
}

std::vector<TradeCase> time_cases(const Document& scene, int depth) {
  std::vector<TradeCase> list;
  for (int substeps = 1; substeps <= depth; substeps *= 2)
    for (const std::string& name : implicit_schemes(scene)) list.push_back(time_case(scene, name, substeps));
  return list;
}

std::vector<TradeCase> explicit_cases(const Document& scene) {
  std::vector<TradeCase> list;
  for (const sim::Scheme& scheme : sim::schemes()) {
    if (!scheme.is_explicit() || !sim::serves(scheme, scene.scene)) continue;
    const std::string name(scheme.name);
    list.push_back({name + " h=auto", Axis::time, {{"time.integrator", name}, {"time.substeps", "\"auto\""}}});
  }
  return list;
}

std::vector<TradeCase> rest_cases(const Document& scene, const TradeCase& around) {
  std::vector<TradeCase> list;
  TradeCase start = around;
  start.axis = Axis::rest;
  const std::string integrator = setting(around, "time.integrator", scene.scene.time.integrator);
  const bool implicit = !sim::find_scheme(integrator)->is_explicit();
  if (implicit) add_solver_cases(scene.scene.solver, start, list);
  if (implicit) add_distance_cases(scene.scene, start, list);
  if (implicit && lags(scene.scene)) add_lag_cases(scene.scene.solver, start, list);
  add_basis_cases(scene, start, list);
  const auto mass = [](const sim::Body& body) { return std::string(name_of(body.mass)); };
  const auto model = [](const sim::Body& body) { return body.materials.front().model; };
  add_body_case(scene, start, "mass", "lumped", mass, list);
  if (implicit) add_body_case(scene, start, "mass", "consistent", mass, list);
  for (const char* const value : {"corotated", "linear"})
    add_body_case(scene, start, "material.model", value, model, list);
  return list;
}

std::vector<TradeCase> thread_cases(const sim::System& system, int given, const TradeCase& around) {
  std::vector<TradeCase> list;
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  for (int threads = 1; threads <= cores; threads *= 2) {
    if (sim::useful_threads(system, threads) != threads || sim::useful_threads(system, given) == threads) continue;
    list.push_back(with(around, std::to_string(threads) + (threads == 1 ? " thread" : " threads"), thread_option,
                        std::to_string(threads)));
    list.back().axis = Axis::rest;
  }
  return list;
}

TradeCase both(const TradeCase& a, const TradeCase& b, Axis axis) {
  TradeCase result = a;
  result.axis = axis;
  for (const auto& [key, value] : b.settings) result = with(result, "", key, value);
  result.label = a.label + (a.label.empty() || b.label.empty() ? "" : ", ") + b.label;
  return result;
}

}  // namespace app
