#include "sim/build/reduction.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>

#include "sim/build/key_path.h"
#include "sim/build/loads.h"
#include "sim/build/sample.h"
#include "sim/reduce/dead_load.h"
#include "sim/reduce/lifted_terms.h"
#include "sim/solve/mass_product.h"
#include "sim/term/damping.h"
#include "sim/term/spring.h"

namespace sim {

namespace {

bool has_basis(const Body& body) {
  return body.basis.has_value();
}

void check_basis_of(const Body& body, const std::string& key) {
  if (!has_basis(body))
    throw InputError(key, "has no basis, and another body has one: give each body a basis, or none");
  if (body.untangle > 0)
    throw InputError(key + ".untangle", "moves single nodes, which a body with a basis cannot; leave one of them out");
  for (std::size_t k = 0; k < body.pins.size(); ++k) {
    const std::string pin = key + "." + key_of("pin", k);
    if (!body.pins[k].motion.empty())
      throw InputError(pin + ".motion",
                       "a body with a basis, x = X + U c, cannot follow pins that move; leave out the "
                       "basis or the motion");
    if (body.pins[k].release)
      throw InputError(pin + ".release", "a basis holds pins for good: leave out the basis or the release");
  }
}

// U of all bodies, a body's coordinates after those of the one before.
Lift::Rows joined(const Model& model) {
  Eigen::Index r = 0;
  for (const Body& body : model.bodies) r += body.basis->vectors->U.cols();
  Lift::Rows U = Lift::Rows::Zero(model.dofs(), r);
  Eigen::Index column = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Eigen::MatrixXd& own = model.bodies[b].basis->vectors->U;
    U.block(static_cast<Eigen::Index>(model.ranges[b].first_node) * model.D, column, own.rows(), own.cols()) = own;
    column += own.cols();
  }
  return U;
}

Lift::Rows with_mass(const Model& model, const Lift::Rows& U) {
  Lift::Rows MU(U.rows(), U.cols());
  for (Eigen::Index k = 0; k < U.cols(); ++k) MU.col(k) = mass_product(model, U.col(k));
  return MU;
}

// The coordinates' own masses and sizes: a coordinate is as long as the body where it moves a node by the body's size.
void describe_coordinates(const Model& full, const Lift::Rows& U, Model& model) {
  model.D = 1;
  model.node_count = model.body_nodes = static_cast<int>(U.cols());
  model.threads = full.threads;
  model.time = full.time;
  model.solver = full.solver;
  model.dense = true;
  model.X = model.x_start = Eigen::VectorXd::Zero(U.cols());
  model.node_size.resize(U.cols());
  model.energy_scale = full.energy_scale;
  int first = 0;
  for (std::size_t b = 0; b < full.bodies.size(); ++b) {
    const Eigen::MatrixXd& own = full.bodies[b].basis->vectors->U;
    model.masses.push_back(Mass::unit(first, static_cast<int>(own.cols())));
    for (const auto& u : own.colwise())
      model.node_size[first++] =
          full.ranges[b].size / u.reshaped(full.D, own.rows() / full.D).colwise().norm().maxCoeff();
  }
  model.bound = 1e12 * model.node_size.maxCoeff();
}

// f of a load that has risen.
Eigen::VectorXd risen_force(const Model& model, const Term& load) {
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
  Eigen::VectorXd f = still;
  load.add_forces({model.X, still, std::numeric_limits<double>::max(), 0}, *load.make_store(1), f);
  return f;
}

void add_dead_loads(const Model& full, Reduction& reduction) {
  for (const auto& term : full.terms) {
    const std::optional<double> ramp = term->dead_ramp();
    if (!ramp) continue;
    Eigen::VectorXd g = Eigen::VectorXd::Zero(reduction.lift->coordinates());
    reduction.lift->gather(risen_force(full, *term), g);
    reduction.model.terms.push_back(std::make_unique<DeadLoad>(term->info(), std::move(g), *ramp));
  }
}

// The part of beta works on elements, that of alpha on the coordinates' own masses.
void add_damping(const Model& full, std::size_t b, std::vector<const ElasticTerm*> elastic, Reduction& reduction,
                 std::vector<Term*>& lifted) {
  const Body& body = full.bodies[b];
  Body half;
  half.name = body.name;
  half.damping = {body.damping.alpha, 0};
  if (body.damping.alpha > 0)
    reduction.model.terms.push_back(
        std::make_unique<RayleighDamping>(half, reduction.model.masses[b], std::vector<const ElasticTerm*>(), 1));
  half.damping = {0, body.damping.beta};
  if (body.damping.beta == 0) return;
  reduction.terms.push_back(std::make_unique<RayleighDamping>(half, *reduction.massless, std::move(elastic), full.D));
  lifted.push_back(reduction.terms.back().get());
}

void add_lifted(const Lift& lift, std::vector<Term*> terms, int D, Reduction& reduction) {
  if (!terms.empty()) reduction.model.terms.push_back(std::make_unique<LiftedTerms>(lift, std::move(terms), D));
}

// What deforms elements: all of them, or the sample.
void add_elastic(const Parts& parts, Reduction& reduction, std::vector<Term*>& of_all_nodes) {
  const Model& full = parts.model;
  std::vector<std::vector<const ElasticTerm*>> of_body(full.bodies.size());
  std::vector<Term*> sampled;
  std::vector<Term*>& lifted = reduction.sample ? sampled : of_all_nodes;
  if (reduction.sample) {
    for (std::size_t k = 0; k < reduction.sample->elastic.size(); ++k) {
      of_body[static_cast<std::size_t>(reduction.sample->body[k])].push_back(reduction.sample->elastic[k].get());
      lifted.push_back(reduction.sample->elastic[k].get());
    }
  } else {
    for (const ElasticPart& part : full.elastic) {
      of_body[static_cast<std::size_t>(part.body)].push_back(part.term);
      lifted.push_back(full.terms[part.number].get());
    }
  }
  for (std::size_t b = 0; b < of_body.size(); ++b) add_damping(full, b, std::move(of_body[b]), reduction, lifted);
  if (reduction.sample) add_lifted(*reduction.sample->lift, std::move(sampled), full.D, reduction);
}

// Each with a lift of the few nodes that it has.
void add_lifted_springs(const Model& full, const std::vector<Spring>& springs, Reduction& reduction) {
  for (std::size_t k = 0; k < springs.size(); ++k) {
    const ProbePlace place = find_point(full, key_of("spring", k), springs[k].body, springs[k].at);
    const int n = static_cast<int>(place.point.weights.size()), D = full.D;
    Lift::Rows U(n * D, reduction.lift->coordinates());
    Eigen::VectorXd X(n * D);
    std::vector<int> nodes;
    for (int a = 0; a < n; ++a) {
      const Eigen::Index at =
          static_cast<Eigen::Index>(place.first_node + place.mesh->elements(a, place.point.element)) * D;
      U.middleRows(a * D, D) = reduction.lift->U().middleRows(at, D);
      X.segment(a * D, D) = full.X.segment(at, D);
      nodes.push_back(a);
    }
    reduction.lifts.push_back(std::make_unique<Lift>(std::move(U), std::move(X)));
    reduction.terms.push_back(std::make_unique<SpringTerm>(springs[k], nodes, place.point.weights, D));
    add_lifted(*reduction.lifts.back(), {reduction.terms.back().get()}, D, reduction);
  }
}

// U^T M U, the products of a row added to those of the rows before it: the same bits for any number of threads.
Eigen::MatrixXd gram_of(const Lift::Rows& U, const Lift::Rows& MU) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(U.cols(), U.cols());
  for (Eigen::Index i = 0; i < U.rows(); ++i) gram.noalias() += U.row(i).transpose() * MU.row(i);
  return gram;
}

// Schemes divide by the masses of the coordinates, which are 1 as far as U^T M U is.
void check_orthonormal(const Parts& parts, const Eigen::MatrixXd& gram) {
  constexpr double round_off = 1e-6;
  if (parts.scheme->is_static) return;
  if (!((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff() < round_off))
    throw InputError("body.0.basis", "the vectors are not orthonormal in the mass of the bodies");
}

}  // namespace

void check_bases(const Scene& scene) {
  if (std::none_of(scene.bodies.begin(), scene.bodies.end(), has_basis)) return;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) check_basis_of(scene.bodies[b], key_of("body", b));
  for (std::size_t k = 0; k < scene.obstacles.size(); ++k)
    if (!scene.obstacles[k].motion.empty() || scene.obstacles[k].release)
      throw InputError(key_of("obstacle", k) + (scene.obstacles[k].release ? ".release" : ".motion"),
                       "obstacles of bodies with a basis stand still: leave out the basis or this");
}

std::unique_ptr<Reduction> make_reduction(const Parts& parts, const Scene& scene) {
  const Model& full = parts.model;
  if (std::none_of(full.bodies.begin(), full.bodies.end(), has_basis)) return nullptr;
  check_bases(scene);
  for (std::size_t b = 0; b < full.bodies.size(); ++b)
    if (!full.bodies[b].basis->vectors)
      throw InputError(key_of("body", b) + ".basis", "has no vectors yet: sim/study/basis.h makes them");
  auto reduction = std::make_unique<Reduction>();
  reduction->lift = std::make_unique<Lift>(joined(full), full.X);
  reduction->mass = with_mass(full, reduction->lift->U());
  reduction->massless = std::make_unique<Mass>(Mass::unit(0, 0));
  const Eigen::MatrixXd gram = gram_of(reduction->lift->U(), reduction->mass);
  check_orthonormal(parts, gram);
  reduction->gram.compute(gram);
  describe_coordinates(full, reduction->lift->U(), reduction->model);
  reduction->sample = make_sample(full, *reduction->lift);
  add_dead_loads(full, *reduction);
  std::vector<Term*> smooth, barriers;
  add_elastic(parts, *reduction, smooth);
  for (const auto& term : full.terms)
    if (term->role() == Role::applied && !term->dead_ramp())
      (term->limits_moves() ? barriers : smooth).push_back(term.get());
  add_lifted(*reduction->lift, std::move(smooth), full.D, *reduction);
  add_lifted(*reduction->lift, std::move(barriers), full.D, *reduction);
  add_lifted_springs(full, scene.springs, *reduction);
  Coupling coupling(reduction->model.node_count);
  std::vector<int> all(static_cast<std::size_t>(reduction->model.node_count));
  std::iota(all.begin(), all.end(), 0);
  coupling.add(all);
  reduction->model.pattern = coupling.pattern();
  for (Mass& mass : reduction->model.masses) mass.bind(*reduction->model.pattern);
  return reduction;
}

TermInfo basis_info(const Body& body, int D) {
  std::ostringstream what;
  const BasisVectors& vectors = *body.basis->vectors;
  what << name_of(body.basis->kind) << ", " << vectors.U.cols() << " coordinates for " << body.mesh.node_count() * D
       << " unknowns";
  if (vectors.cubature)
    what << "; " << vectors.cubature->elements.size() << " of " << body.mesh.element_count()
         << " elements, whose forces are off by " << 100 * vectors.cubature->error << " % at "
         << vectors.cubature->states << " states";
  return {"basis " + body.name, what.str()};
}

}  // namespace sim
