#include "sim/study/cubature.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "sim/build/key_path.h"
#include "sim/build/parts.h"
#include "sim/build/sample.h"
#include "sim/linear/nonnegative.h"
#include "sim/stepper.h"
#include "sim/study/swing.h"

namespace sim {

namespace {

constexpr double tenth = 0.1;          // of the body's size, by which the weight along an axis bends it
constexpr int most_candidates = 4000;  // elements among which some are chosen

// The coordinates at every `stride`-th step of a swing, one state a column.
void add_swing(const Scene& one, int stride, int threads, std::vector<Eigen::VectorXd>& states) {
  const System system(one, threads);
  const auto stepper = make_stepper(system, useful_threads(system, threads));
  State state = system.initial_state();
  for (int k = 1; k <= steps_a_swing; ++k) {
    if (!stepper->step(state).failure.empty()) return;
    if (k % stride == 0) states.push_back(state.coordinates.c);
  }
}

Eigen::MatrixXd swings(const Scene& scene, std::size_t b, int threads) {
  Scene one = alone_in_basis(scene, b);
  const Response response = response_in_basis(one);
  one = swinging(std::move(one), response.omega);
  std::vector<Eigen::VectorXd> states;
  add_swing(one, 1, threads, states);
  for (int axis = 0; axis < scene.dimension; ++axis)
    if (response.per_axis[axis] > 0)
      add_swing(under_weight(one, axis, tenth * response.size / response.per_axis[axis]), 2, threads, states);
  Eigen::MatrixXd c(one.bodies[0].basis->vectors->U.cols(), std::ssize(states));
  for (std::size_t k = 0; k < states.size(); ++k) c.col(static_cast<Eigen::Index>(k)) = states[k];
  return c;
}

Eigen::MatrixXd of_snapshots(const Scene& scene, std::size_t b) {
  const System system(alone_in_basis(scene, b));
  const Reduction& reduction = *parts_of(system).reduction;
  const Eigen::MatrixXd& all = *scene.bodies[b].basis->snapshots;
  Eigen::MatrixXd c(reduction.lift->coordinates(), all.cols());
  for (Eigen::Index k = 0; k < all.cols(); ++k) c.col(k) = reduction.rate_of(all.col(k));
  return c;
}

// All elements, or some of them in an order that follows from nothing.
std::vector<int> candidates(int elements) {
  std::vector<int> all(static_cast<std::size_t>(elements));
  std::iota(all.begin(), all.end(), 0);
  if (elements <= most_candidates) return all;
  std::mt19937_64 random(1);
  for (std::size_t k = 0; k < most_candidates; ++k) std::swap(all[k], all[k + random() % (all.size() - k)]);
  all.resize(most_candidates);
  std::sort(all.begin(), all.end());
  return all;
}

// The elastic forces on the coordinates, of all elements.
Eigen::MatrixXd whole_forces(const Scene& scene, std::size_t b, const Eigen::MatrixXd& c) {
  const System system(alone_in_basis(scene, b));
  const Model& model = parts_of(system).model;
  const Lift& lift = *parts_of(system).reduction->lift;
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(lift.dofs());
  Eigen::VectorXd x, f, g, state;
  Eigen::MatrixXd all(c.rows(), c.cols());
  for (Eigen::Index k = 0; k < c.cols(); ++k) {
    state = c.col(k);
    lift.place(state, x);
    f.setZero(x.size());
    for (const ElasticPart& part : model.elastic) part.term->add_forces({x, still, 0, 0}, *part.term->make_store(1), f);
    g.setZero(c.rows());
    lift.gather(f, g);
    all.col(k) = g;
  }
  return all;
}

// States that push hardly say nothing; the others count alike, whatever their forces.
void keep_loud(Eigen::MatrixXd& c, Eigen::MatrixXd& forces) {
  constexpr double quiet = 1e-3;
  const Eigen::VectorXd norms = forces.colwise().norm();
  std::vector<Eigen::Index> loud;
  for (Eigen::Index k = 0; k < norms.size(); ++k)
    if (std::isfinite(norms[k]) && norms[k] > quiet * norms.maxCoeff()) loud.push_back(k);
  c = Eigen::MatrixXd(c(Eigen::indexing::all, loud));
  forces = Eigen::MatrixXd(forces(Eigen::indexing::all, loud));
}

Cubature trained(const Scene& scene, std::size_t b, int threads) {
  const Basis& basis = *scene.bodies[b].basis;
  Eigen::MatrixXd c = basis.snapshots ? of_snapshots(scene, b) : swings(scene, b, threads);
  Eigen::MatrixXd forces = whole_forces(scene, b, c);
  keep_loud(c, forces);
  if (c.cols() == 0)
    throw InputError(key_of("body", b) + ".basis.cubature", "the states of the training push no element");
  const std::vector<int> chosen_from = candidates(scene.bodies[b].mesh.element_count());
  Eigen::MatrixXd G = element_forces(scene, b, chosen_from, c);
  for (Eigen::Index k = 0; k < c.cols(); ++k) {
    G.middleRows(k * c.rows(), c.rows()) /= forces.col(k).norm();
    forces.col(k).normalize();
  }
  const FewWeights few = few_nonnegative(G, forces.reshaped(), basis.cubature);
  Cubature cubature{{}, few.weights, few.error, static_cast<int>(c.cols())};
  for (const int column : few.columns) cubature.elements.push_back(chosen_from[static_cast<std::size_t>(column)]);
  return cubature;
}

}  // namespace

Eigen::MatrixXd element_forces(const Scene& scene, std::size_t body, const std::vector<int>& elements,
                               const Eigen::MatrixXd& c) {
  const Body& whole = scene.bodies[body];
  const int D = scene.dimension, n = static_cast<int>(whole.mesh.elements.rows());
  const int nodes = n * static_cast<int>(elements.size());
  const ApartElements apart = elements_apart(whole, body, elements, {}, 0, nodes, D);
  Eigen::MatrixXd U(nodes * D, c.rows());
  Eigen::VectorXd X = Eigen::VectorXd::Zero(nodes * D);
  for (int i = 0; i < nodes; ++i) {
    U.middleRows(i * D, D) = whole.basis->vectors->U.middleRows(Eigen::Index{D} * apart.nodes[i], D);
    X.segment(i * D, whole.mesh.dimension()) = apart.body->mesh.X.col(i);
  }
  std::vector<std::unique_ptr<Term::Store>> stores;
  for (const auto& term : apart.elastic) stores.push_back(term->make_store(1));
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(X.size());
  Eigen::MatrixXd all(c.rows() * c.cols(), std::ssize(elements));
  Eigen::VectorXd x, f;
  for (Eigen::Index k = 0; k < c.cols(); ++k) {
    x = X;
    x.noalias() += U * c.col(k);
    f.setZero(x.size());
    for (std::size_t t = 0; t < stores.size(); ++t) apart.elastic[t]->add_forces({x, still, 0, 0}, *stores[t], f);
    for (Eigen::Index e = 0; e < all.cols(); ++e)
      all.col(e).segment(k * c.rows(), c.rows()).noalias() =
          U.middleRows(e * n * D, n * D).transpose() * f.segment(e * n * D, n * D);
  }
  return all;
}

void train_cubatures(Scene& scene, int threads) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Basis& basis = *scene.bodies[b].basis;
    if (basis.cubature == 0 || basis.vectors->cubature) continue;
    auto vectors = std::make_shared<BasisVectors>(*basis.vectors);
    vectors->cubature = trained(scene, b, threads);
    basis.vectors = std::move(vectors);
  }
}

}  // namespace sim
