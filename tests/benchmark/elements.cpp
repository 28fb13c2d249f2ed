// Nanoseconds per tet: force, clamped tangent and matrix, product without a matrix; and the textbook way beside them.
#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "sim/build/parts.h"
#include "sim/material/neo_hookean.h"
#include "sim/solve/tangent_operator.h"
#include "tests/benchmark/beam.h"

namespace {

using benchmarks::beam;

struct Terms {
  sim::System system;
  sim::TangentOperator tangent;
  sim::BlockMatrix matrix;
  Eigen::VectorXd x, v, f, p;
  sim::Motion motion;
  const sim::Term& elastic;
  sim::Term::Store& store;
  int elements;

  Terms(int n, const char* model, int threads)
      : system(beam(n, model)),
        tangent(parts_of(system).model, threads),
        matrix(*parts_of(system).model.pattern, 3),
        x(benchmarks::bent(parts_of(system).model.X)),
        v(Eigen::VectorXd::Zero(x.size())),
        f(v),
        p(x),
        motion{x, v, 0, 60},
        elastic(*parts_of(system).model.terms[0]),
        store(*tangent.stores()[0]),
        elements(system.counts().elements) {
    elastic.linearise(motion, sim::Definiteness::clamp, store, f);
  }
};

const char* const models[] = {"neo-hookean", "stable-neo-hookean", "corotated"};

template <class F>
void per_tet(benchmark::State& state, const F& f) {
  Terms terms(8, models[state.range(0)], static_cast<int>(state.range(1)));
  for (auto _ : state) f(terms);
  state.SetLabel(models[state.range(0)]);
  state.counters["per_tet"] = benchmark::Counter(
      static_cast<double>(terms.elements), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void force(benchmark::State& state) {
  per_tet(state, [](Terms& t) { t.elastic.add_forces(t.motion, t.store, t.f); });
}
void force_and_clamped_stiffness_scattered(benchmark::State& state) {
  per_tet(state, [](Terms& t) {
    t.elastic.linearise(t.motion, sim::Definiteness::clamp, t.store, t.f);
    t.elastic.add_matrix(t.store, 1, t.matrix);
    t.matrix.mirror(t.tangent.threads());
  });
}
void product_without_matrix(benchmark::State& state) {
  per_tet(state, [](Terms& t) { t.elastic.add_product(t.store, 1, t.p, t.f); });
}

// Dense 12 x 12 element stiffness B^T (dP/dF) B, its eigenvalues found numerically and clamped.
void textbook_stiffness(benchmark::State& state) {
  Terms terms(2, "neo-hookean", 1);
  const sim::NeoHookean material(sim::lame(1e6, 0.45, false), 3);
  const sim::Mesh& mesh = *terms.system.bodies()[0].mesh;
  for (auto _ : state)
    for (int e = 0; e < mesh.element_count(); ++e) {
      Eigen::Matrix3d Dm, Ds;
      for (int a = 1; a < 4; ++a) {
        const int i = mesh.elements(0, e), j = mesh.elements(a, e);
        Dm.col(a - 1) = mesh.X.col(j) - mesh.X.col(i);
        Ds.col(a - 1) = terms.x.segment<3>(3 * j) - terms.x.segment<3>(3 * i);
      }
      const Eigen::Matrix3d G = Dm.inverse(), F_ = Ds * G;
      sim::Mat<double, 3, 3> F, P;
      for (int i = 0; i < 9; ++i) F(i / 3, i % 3) = F_(i / 3, i % 3);
      sim::Tangent<double, 3, 3> t;
      material.linearise(F, P, t);
      Eigen::Matrix<double, 9, 9> A;
      for (int k = 0; k < 9; ++k) {
        auto unit = sim::Mat<double, 3, 3>::zero();
        unit(k / 3, k % 3) = 1;
        const auto column = sim::apply(t, unit);
        for (int i = 0; i < 9; ++i) A(i, k) = column(i / 3, i % 3);
      }
      Eigen::Matrix<double, 9, 12> B = Eigen::Matrix<double, 9, 12>::Zero();
      for (int c = 0; c < 3; ++c)
        for (int m = 0; m < 3; ++m)
          for (int a = 0; a < 3; ++a) {
            B(3 * c + m, 3 * (a + 1) + c) = G(a, m);
            B(3 * c + m, c) -= G(a, m);
          }
      const Eigen::Matrix<double, 12, 12> K = B.transpose() * A * B;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> eigen(K);
      Eigen::Matrix<double, 12, 12> clamped =
          eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
      benchmark::DoNotOptimize(clamped);
    }
  state.counters["per_tet"] =
      benchmark::Counter(static_cast<double>(mesh.element_count()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// The least of some repetitions is what a machine with other work on it can tell.
template <typename Benchmark>  // whose name differs between versions
void least(Benchmark* b) {
  b->Repetitions(10)->ReportAggregatesOnly()->ComputeStatistics(
      "least", [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); });
}

BENCHMARK(force)->ArgsProduct({{0, 1, 2}, {1, 2}})->UseRealTime();
BENCHMARK(force_and_clamped_stiffness_scattered)->ArgsProduct({{0, 1, 2}, {1, 2}})->UseRealTime()->Apply(least);
BENCHMARK(product_without_matrix)->ArgsProduct({{0}, {1, 2}})->UseRealTime();
BENCHMARK(textbook_stiffness)->Apply(least);

}  // namespace
