// Milliseconds: a factorisation, a solve, a product with the matrix, a whole step at the default settings.
#include <benchmark/benchmark.h>

#include "sim/build/parts.h"
#include "sim/linear/cholesky.h"
#include "sim/solve/tangent_operator.h"
#include "tests/benchmark/beam.h"

namespace {

struct Factored {
  sim::System system;
  sim::TangentOperator tangent;
  sim::BlockMatrix matrix;
  sim::Cholesky cholesky;
  Eigen::VectorXd x, b;

  explicit Factored(int n)
      : system(benchmarks::beam(n, "stable-neo-hookean")),
        tangent(parts_of(system).model, 1),
        matrix(*parts_of(system).model.pattern, 3),
        x(parts_of(system).model.X),
        b(Eigen::VectorXd::Ones(x.size())) {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(x.size());
    parts_of(system).model.pins.mark(0, tangent.free());
    Eigen::VectorXd f(x.size());
    tangent.begin_step({x, still, 0, 0});
    tangent.linearise({x, still, 0, 60}, 3600, sim::Definiteness::clamp, f);
    tangent.assemble(matrix);
    cholesky.analyse(matrix, tangent.free());
    cholesky.factorise(matrix);
  }
};

void factorisation(benchmark::State& state) {
  Factored factored(static_cast<int>(state.range(0)));
  for (auto _ : state) factored.cholesky.factorise(factored.matrix);
}
void solve(benchmark::State& state) {
  Factored factored(static_cast<int>(state.range(0)));
  for (auto _ : state) factored.cholesky.solve(factored.b, factored.x);
}
void product_with_matrix(benchmark::State& state) {
  Factored factored(static_cast<int>(state.range(0)));
  for (auto _ : state) factored.matrix.multiply(factored.b, factored.x, 1);
}

// Backward Euler, h = 1/60 s, Newton to the default tolerance: the mean over the first simulated second.
void step(benchmark::State& state) {
  const int threads = static_cast<int>(state.range(1));
  sim::test::Stepped run(benchmarks::beam(static_cast<int>(state.range(0)), "stable-neo-hookean"), threads);
  int newton = 0, linear = 0, factorisations = 0, steps = 0;
  for (auto _ : state) {
    run.last = run.stepper->step(run.state);
    newton += run.last.newton;
    linear += run.last.linear;
    factorisations += run.last.factorisations;
    ++steps;
  }
  state.counters["newton"] = static_cast<double>(newton) / steps;
  state.counters["linear"] = static_cast<double>(linear) / steps;
  state.counters["factorisations"] = static_cast<double>(factorisations) / steps;
}

BENCHMARK(factorisation)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK(solve)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK(product_with_matrix)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK(step)->ArgsProduct({{8, 12}, {1, 2}})->Iterations(60)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
