#include "sim/build/build.h"

#include <algorithm>
#include <cmath>

#include "sim/body/start.h"
#include "sim/build/barrier_scheme.h"
#include "sim/build/contacts.h"
#include "sim/build/held.h"
#include "sim/build/key_path.h"
#include "sim/build/loads.h"
#include "sim/build/materials.h"
#include "sim/build/obstacles.h"
#include "sim/build/reduction.h"
#include "sim/element/element.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/order.h"
#include "sim/solve/linear_solver.h"
#include "sim/solve/newton.h"
#include "sim/term/damping.h"
#include "sim/term/gravity.h"
#include "sim/term/untangle.h"
#include "sim/time/implicit.h"
#include "sim/time/stable_step.h"

namespace sim {

namespace {

BodyRange range_of(const Body& body, const BodyRange* last) {
  BodyRange range{body.name, 0, body.mesh.node_count(), 0, body.mesh.element_count(), 0, nullptr};
  if (last) {
    range.first_node = last->first_node + last->node_count;
    range.first_element = last->first_element + last->element_count;
  }
  range.size = (body.mesh.X.rowwise().maxCoeff() - body.mesh.X.rowwise().minCoeff()).maxCoeff();
  return range;
}

void add_body(Model& model, std::size_t b) {
  const Body& body = model.bodies[b];
  const BodyRange& range = model.ranges[b];
  const std::vector<int> material = material_of_elements(body, b);
  std::vector<double> density(material.size());
  for (std::size_t e = 0; e < material.size(); ++e) density[e] = body.materials[material[e]].density;
  below(key_of("body", b), [&] { model.masses.emplace_back(body, density, range.first_node); });
  const std::vector<int> order = spatial_order(body.mesh);
  for (std::size_t m = 0; m < body.materials.size(); ++m) {
    ElasticInput input{body, body.materials[m], {}, range.first_node, model.node_count};
    for (const int e : order)
      if (material[e] == static_cast<int>(m)) input.elements.push_back(e);
    if (input.elements.empty()) continue;
    auto term = below(key_of("body", b), [&] { return make_elastic(input, model.D); });
    model.elastic.push_back({term.get(), model.terms.size(), static_cast<int>(b)});
    model.energy_scale += body.materials[m].young * term->volume();
    model.terms.push_back(std::move(term));
  }
  for (std::size_t k = 0; k < body.pins.size(); ++k) {
    const std::string key = key_of("body", b) + "." + key_of("pin", k);
    std::vector<int> nodes = below(key, [&] { return nodes_in(body.mesh, body.pins[k].where); });
    if (nodes.empty())
      throw InputError(key, "no node of \"" + body.name + "\" is in this region; " + span_text(body.mesh));
    for (int& node : nodes) node += range.first_node;
    model.pins.add(body.pins[k], nodes, body.pins[k].at_start ? model.x_start : model.X, model.D,
                   {"pin " + std::to_string(k) + " of \"" + body.name + "\"", body.name});
  }
}

void place_nodes(Model& model) {
  for (const Body& body : model.bodies)
    model.ranges.push_back(range_of(body, model.ranges.empty() ? nullptr : &model.ranges.back()));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) model.ranges[b].mesh = &model.bodies[b].mesh;
  model.body_nodes = model.ranges.empty() ? 0 : model.ranges.back().first_node + model.ranges.back().node_count;
  number_obstacle_nodes(model);
  model.X = Eigen::VectorXd::Zero(model.dofs());
  model.node_size.resize(model.node_count);
  for (const BodyRange& range : model.ranges) {
    model.node_size.segment(range.first_node, range.node_count).setConstant(range.size);
    for (int i = 0; i < range.node_count; ++i)
      model.X.segment(static_cast<Eigen::Index>(range.first_node + i) * model.D, range.mesh->dimension()) =
          range.mesh->X.col(i);
  }
  place_obstacle_nodes(model);
  model.bound = 1e12 * model.X.lpNorm<Eigen::Infinity>();
}

// Where the bodies start; each has random numbers of its own.
void place_start(Model& model, std::uint64_t seed) {
  model.x_start = model.X;
  move_obstacles_to_start(model);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Start& start = model.bodies[b].start;
    if (start.shape == "rest" && !start.perturbation) continue;
    const Eigen::MatrixXd x = below(key_of("body", b), [&] {
      return start_positions(model.bodies[b].mesh, start, model.D, seed + b * 0x9e3779b97f4a7c15);
    });
    model.x_start.segment(static_cast<Eigen::Index>(model.ranges[b].first_node) * model.D, x.size()) = x.reshaped();
  }
}

// A material whose energy is infinite where J <= 0 cannot start there.
void check_start(const Model& model) {
  const Eigen::Index own = static_cast<Eigen::Index>(model.body_nodes) * model.D;
  if (model.x_start.head(own) == model.X.head(own)) return;
  Eigen::VectorXd x = model.x_start, v = Eigen::VectorXd::Zero(model.dofs());
  model.pins.prescribe(0, x, v);
  for (const auto& [term, number, body] : model.elastic) {
    const auto store = term->make_store(1);
    if (std::isfinite(term->energy({x, v, 0, 0}, *store))) continue;
    const ElasticTerm::SmallestJ least = term->smallest_J(x, *store);
    const std::string what = term->info().what;
    const std::string where = "element " + std::to_string(least.element) + " has J = " + std::to_string(least.J);
    throw InputError(key_of("body", body) + ".start",
                     (least.inverted == 0 ? "deforms elements so far (" + where
                                          : "inverts " + std::to_string(least.inverted) + " elements (" + where) +
                         "), where the energy of " + what.substr(0, what.find(',')) +
                         " is infinite: start elsewhere, or take " +
                         (what.starts_with("stable") ? "" : "stable-neo-hookean or ") + "fixed-corotated");
  }
}

// Effects of the body's own: what undoes its tangles, and damping.
void add_own_terms(Model& model, std::size_t b) {
  const Body& body = model.bodies[b];
  if (body.untangle > 0)
    model.terms.push_back(std::make_unique<UntangleTerm>(body, material_of_elements(body, b),
                                                         model.ranges[b].first_node, model.X, model.pins, model.D));
  if (body.damping.alpha == 0 && body.damping.beta == 0) return;
  std::vector<const ElasticTerm*> own;
  for (const ElasticPart& part : model.elastic)
    if (part.body == static_cast<int>(b)) own.push_back(part.term);
  model.terms.push_back(std::make_unique<RayleighDamping>(body, model.masses[b], std::move(own), model.D));
}

// Explicit schemes with substeps = 0: what stability needs, with a margin for what stiffens while it moves.
void settle_substeps(Parts& parts) {
  constexpr double margin = 0.8;
  Model& model = parts.model;
  if (model.time.substeps > 0) return;
  model.time.substeps = 1;
  if (!parts.scheme->is_explicit()) return;
  const double h = margin * stable_step(parts.moving());
  model.time.substeps = std::max(1, static_cast<int>(std::ceil(1.0 / (model.time.fps * h))));
  model.watches_step = true;
  parts.remarks.push_back("explicit: " + std::to_string(model.time.substeps) +
                          " steps a frame, as stability needs at rest; they are parted where the body stiffens");
}

void form_pattern(Parts& parts) {
  if (parts.scheme->is_explicit() || parts.reduction) return;
  Model& model = parts.model;
  const bool by_itself = model.solver.linear == LinearSolverKind::automatic;
  if (!model.contacts.empty() && model.solver.newton == NewtonKind::pure)
    throw InputError("solver.newton",
                     "\"pure\" is not for scenes with a [[contact]] or an obstacle that is a mesh, whose "
                     "steps must be cut");
  model.solver.linear = settled_solver(model.solver.linear, model.dofs());
  if (by_itself && model.node_count > 0)
    parts.remarks.push_back(model.solver.linear == LinearSolverKind::two_level
                                ? "solver: conjugate gradients on two levels, for this size"
                                : "solver: conjugate gradients on two levels; CHOLMOD from where they take too long");
  if (!forms_matrix(model.solver)) return;
  Coupling coupling(model.node_count);
  for (const Mass& mass : model.masses) mass.couple(coupling);
  for (const auto& term : model.terms) term->couple(coupling);
  model.pattern = coupling.pattern();
  for (Mass& mass : model.masses) mass.bind(*model.pattern);
  for (const auto& term : model.terms) term->bind(*model.pattern);
}

}  // namespace

std::unique_ptr<Parts> build(const Scene& scene, int threads) {
  auto parts = std::make_unique<Parts>();
  parts->scheme = find_scheme(scene.time.integrator);
  if (!parts->scheme) throw InputError("time.integrator", "\"" + scene.time.integrator + "\" is not a scheme");
  check_barrier_scheme(*parts, scene);
  Model& model = parts->model;
  model.D = scene.dimension;
  model.threads = threads;
  model.time = scene.time;
  model.solver = scene.solver;
  model.bodies = scene.bodies;
  model.obstacles = scene.obstacles;
  // Nothing is divided by the mass of a static scene; its weight is that of the true integrals.
  if (parts->scheme->is_static)
    for (Body& body : model.bodies) body.mass = MassMatrix::consistent;
  place_nodes(model);
  place_start(model, scene.seed);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) add_body(model, b);
  if (scene.world.gravity.head(model.D).norm() > 0)
    model.terms.push_back(std::make_unique<Gravity>(scene.world.gravity, model.masses, model.X, model.D));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    add_loads(model, b);
    add_own_terms(model, b);
  }
  add_obstacles(*parts);
  add_contacts(*parts, scene);
  parts->reduction = make_reduction(*parts, scene);
  add_springs(model, scene.springs);
  for (std::size_t k = 0; k < scene.probes.size(); ++k)
    parts->probes.push_back(find_point(model, key_of("probe", k), scene.probes[k].body, scene.probes[k].at));
  check_start(model);
  if (parts->scheme->is_static) parts->no_equilibrium = moved_as_a_whole(model, scene.springs);
  settle_substeps(*parts);
  if (parts->reduction) {
    parts->reduction->model.time = model.time;
    parts->reduction->model.watches_step = model.watches_step;
  }
  form_pattern(*parts);
  return parts;
}

}  // namespace sim
