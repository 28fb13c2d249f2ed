// A bent body and its matrices, for the tests of sim/linear/.
#pragma once

#include <gtest/gtest.h>

#include "sim/linear/block_system.h"
#include "sim/linear/coarse_matrix.h"
#include "sim/solve/tangent_operator.h"
#include "tests/sim/scenes.h"

namespace sim::test {

// The matrix of a free body's Newton step where it is bent, and what stands around it.
struct Bent {
  System system;
  const Model& model;
  TangentOperator tangent;
  Eigen::VectorXd x, free;
  BlockMatrix A;
  std::vector<int> first_node;
  Aggregates aggregates;

  Bent(const Kind& kind, int cells, double mass, int size, bool pinned = false)
      : system(free_body(kind, "stable-neo-hookean", cells)),
        model(parts_of(system).model),
        tangent(model, 1),
        x(model.X + random_vector(model.dofs(), 0.05 / cells, 3)),
        free(Eigen::VectorXd::Ones(model.dofs())),
        A(*model.pattern, model.D),
        first_node({0, model.node_count}),
        aggregates(bisect(model.X, model.D, first_node, size)) {
    if (pinned)
      for (Eigen::Index i = 0; i < free.size(); i += 7) free[i] = 0;
    tangent.free() = free;
    Eigen::VectorXd f(model.dofs());
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
    tangent.begin_step({x, still, 0, 0});
    tangent.linearise({x, still, 0, 0}, mass, Definiteness::clamp, f);
    tangent.assemble(A);
  }
  Eigen::VectorXd ordered(const Eigen::VectorXd& v) const {
    Eigen::VectorXd result(v.size());
    for (std::size_t k = 0; k < aggregates.order.size(); ++k)
      result.segment(k * model.D, model.D) = v.segment(aggregates.order[k] * model.D, model.D);
    return result;
  }
  // A on the free components, in the order of the aggregates.
  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd result(x.size(), x.size());
    Eigen::VectorXd column(x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      A.multiply(Eigen::VectorXd::Unit(x.size(), k).cwiseProduct(free), column, 1);
      result.col(k) = ordered(column.cwiseProduct(free));
    }
    Eigen::MatrixXd turned = result.transpose();
    for (Eigen::Index k = 0; k < x.size(); ++k) result.col(k) = ordered(turned.col(k));
    return result;
  }
};

template <int D>
FloatMatrix<D> float_matrix(const Bent& body) {
  FloatMatrix<D> F(*body.model.pattern, body.aggregates.order);
  F.restrict_to(body.ordered(body.free));
  F.take(body.A, 1);
  return F;
}

template <int D>
Eigen::MatrixXd dense(const FloatMatrix<D>& F) {
  const Eigen::Index n = static_cast<Eigen::Index>(F.rows()) * D;
  Eigen::MatrixXd result(n, n);
  Eigen::VectorXd p(n + 1);
  for (Eigen::Index k = 0; k < n; ++k) {
    p.setZero();
    p[k] = 1;
    F.multiply(0, F.rows(), p.data(), result.col(k).data());
  }
  return result / F.scale();
}

template <int D>
Eigen::MatrixXd coarse_space(const Bent& body, const RigidModes<D>& modes) {
  constexpr int n = RigidModes<D>::count;
  const Eigen::VectorXd free = body.ordered(body.free);
  Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(body.x.size(), body.aggregates.count() * n);
  for (int a = 0; a < body.aggregates.count(); ++a)
    for (int k = body.aggregates.start[a]; k < body.aggregates.start[a + 1]; ++k)
      Q.block<D, n>(k * D, a * n) = free.segment<D>(k * D).asDiagonal() * modes.motion(k) * modes.T(a);
  return Q;
}

template <class F>
void for_each_case(const F& f) {
  for (const Kind& kind : kinds)
    for (const bool pinned : {false, true}) {
      SCOPED_TRACE(std::string(kind.element) + (kind.membrane ? " membrane" : "") + (pinned ? " pinned" : ""));
      const Bent body(kind, 3, 1e3, 12, pinned);
      if (body.model.D == 2)
        f.template operator()<2>(body);
      else
        f.template operator()<3>(body);
    }
}

}  // namespace sim::test
