#include "sim/build/held.h"

#include <Eigen/Eigenvalues>

#include "sim/mesh/components.h"
#include "sim/mesh/locate.h"

namespace sim {
namespace {

// The rigid motions of a part as columns, D numbers per node: translations along the axes, then rotations about the
// middle of what is held, or of all where nothing is, scaled by its size so that all are lengths.
Eigen::MatrixXd rigid_motions(const Model& model, const std::vector<int>& nodes, const Eigen::VectorXd& held) {
  const int D = model.D, count = D == 2 ? 3 : 6;
  Vec3 centre = Vec3::Zero();
  const auto X = [&](int node) {
    Vec3 x = Vec3::Zero();
    x.head(D) = model.X.segment(static_cast<Eigen::Index>(node) * D, D);
    return x;
  };
  double weight = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double share = held.sum() == 0 ? 1 : held.segment(static_cast<Eigen::Index>(i) * D, D).sum();
    centre += share * X(nodes[i]);
    weight += share;
  }
  centre /= weight;
  const double size = model.node_size[nodes[0]];
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(nodes.size()) * D, count);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vec3 arm = (X(nodes[i]) - centre) / size;
    const auto row = static_cast<Eigen::Index>(i) * D;
    for (int c = 0; c < D; ++c) motions(row + c, c) = 1;
    for (int r = D; r < count; ++r) {
      const Vec3 axis = D == 2 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::Unit(r - D));
      motions.block(row, r, D, 1) = axis.cross(arm).head(D);
    }
  }
  return motions;
}

// The combinations of the rigid motions (columns) that move no held component.
Eigen::MatrixXd free_combinations(const Eigen::MatrixXd& motions, const Eigen::VectorXd& held) {
  constexpr double rounding = 1e-10;
  const Eigen::MatrixXd resisted = motions.transpose() * held.asDiagonal() * motions;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(resisted);
  const double scale = motions.squaredNorm();
  const auto free = static_cast<Eigen::Index>((modes.eigenvalues().array() <= rounding * scale).count());
  return modes.eigenvectors().leftCols(free);
}

// Components that a pin prescribes, and those of nodes that a spring pulls.
Eigen::VectorXd held_components(const Model& model, const std::vector<Spring>& springs) {
  Eigen::VectorXd held(model.dofs());
  model.pins.mark(0, held);
  held = (1 - held.array()).matrix();
  for (const Spring& spring : springs) {
    for (const BodyRange& body : model.ranges) {
      const auto point = body.name == spring.body ? locate(*body.mesh, spring.at) : std::nullopt;
      if (!point) continue;
      for (const int node : body.mesh->elements.col(point->element))
        held.segment(static_cast<Eigen::Index>(body.first_node + node) * model.D, model.D).setOnes();
    }
  }
  return held;
}

Eigen::VectorXd load_at_start(const Model& model) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(model.dofs());
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.dofs());
  const Motion late{model.x_start, v, 1e30, 0};  // loads have risen
  for (const auto& term : model.terms) {
    if (term->role() == Role::elastic) continue;
    const auto store = term->make_store(1);
    term->begin_step(late, *store);
    term->add_forces(late, *store, f);
  }
  return f;
}

std::string listed(const Eigen::MatrixXd& combinations, int D) {
  const Eigen::VectorXd share = combinations.rowwise().squaredNorm();
  constexpr double part = 1e-6;
  std::string text;
  for (int r = 0; r < share.size(); ++r) {
    if (share[r] <= part) continue;
    const std::string axis(1, r < D ? "xyz"[r] : D == 2 ? 'z' : "xyz"[r - D]);
    text += (text.empty() ? "" : ", ") + std::string(r < D ? "along " : "about ") + axis;
  }
  return text;
}

}  // namespace

std::string moved_as_a_whole(const Model& model, const std::vector<Spring>& springs) {
  if (model.limits_moves()) return {};
  constexpr double rounding = 1e-9;
  const int D = model.D;
  const Eigen::VectorXd held = held_components(model, springs), f = load_at_start(model);
  for (const BodyRange& body : model.ranges) {
    for (const Component& part : components(*body.mesh)) {
      std::vector<int> nodes = part.nodes;
      for (int& node : nodes) node += body.first_node;
      Eigen::VectorXd own_held(static_cast<Eigen::Index>(nodes.size()) * D), load(own_held.size());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        own_held.segment(static_cast<Eigen::Index>(i) * D, D) =
            held.segment(static_cast<Eigen::Index>(nodes[i]) * D, D);
        load.segment(static_cast<Eigen::Index>(i) * D, D) = f.segment(static_cast<Eigen::Index>(nodes[i]) * D, D);
      }
      const Eigen::MatrixXd motions = rigid_motions(model, nodes, own_held);
      const Eigen::MatrixXd free = free_combinations(motions, own_held);
      if (free.cols() == 0) continue;
      const double work = (free.transpose() * (motions.transpose() * load)).norm();
      if (work <= rounding * load.lpNorm<1>()) continue;
      return "nothing holds \"" + body.name + "\" against its load: " + std::to_string(free.cols()) +
             (free.cols() == 1 ? " motion" : " motions") + " of a rigid body " + (free.cols() == 1 ? "is" : "are") +
             " free (" + listed(free, D) + "); pin it, or take an integrator that moves";
    }
  }
  return {};
}

}  // namespace sim
