// What a step keeps: exact free fall, the same bits for any threads and any way of getting there, pins, no matrix.
#include "tests/sim/stepping.h"

#include "sim/build/parts.h"
#include "sim/mesh/input_error.h"
#include "sim/solve/linear_solver.h"
#include "sim/stepper.h"

namespace sim {
namespace {

using test::Stepped;

const char* const implicit_schemes[] = {"backward-euler", "bdf2",    "trapezoidal",      "implicit-midpoint",
                                        "sdirk2",         "tr-bdf2", "linearly-implicit"};

// A body that falls keeps its shape, and falls as the scheme falls: exactly for those of order 2.
TEST(FreeFall, IsExact) {
  for (const Scheme& scheme : schemes()) {
    if (scheme.is_static) continue;
    Scene scene = test::free_body({"tet4", false}, "stable-neo-hookean");
    scene.world.gravity = {1, -9.81, 0.5};
    scene.bodies[0].velocity = {0.3, 2, -1};
    scene.time.integrator = std::string(scheme.name);
    scene.time.substeps = 8;
    scene.solver.tolerance = 1e-10;
    Stepped run(scene);
    run.steps(40);
    const double t = run.system.time(40), h = run.system.step_seconds();
    // x = v t + g t (t + e h)/2 with e = 1 for the two Euler schemes.
    const double e = scheme.order == 2 ? 0 : 1;
    const Vec3 moved = scene.bodies[0].velocity * t + scene.world.gravity * t * (t + e * h) / 2;
    const Eigen::VectorXd& X = parts_of(run.system).model.X;
    for (Eigen::Index i = 0; i < X.size(); ++i) EXPECT_NEAR(run.state.x[i] - X[i], moved[i % 3], 1e-9) << scheme.name;
  }
}

TEST(SameBits, ForAnyNumberOfThreads) {
  for (const char* element : {"tet4", "tet10", "hex8"})
    for (const auto& [linear, name] : choices<LinearSolverKind>) {
      Scene scene = test::beam(element, 3);
      scene.solver.linear = linear;
      Stepped one(scene, 1), two(scene, 2), four(scene, 4);
      one.steps(8);
      two.steps(8);
      four.steps(8);
      EXPECT_EQ(hash(one.state), hash(two.state)) << element << " " << name_of(linear);
      EXPECT_EQ(hash(one.state), hash(four.state)) << element << " " << name_of(linear);
    }
}

// Small bodies are stepped on one thread, which is faster; all the others share the work.
TEST(UsefulThreads, GrowWithTheBody) {
  int before = 0;
  for (const int n : {1, 4, 12}) {
    const System system(test::beam("tet4", n));
    const int threads = useful_threads(system, 64);
    EXPECT_EQ(threads, std::max<int>(1, static_cast<int>(parts_of(system).model.dofs()) / 10000));
    EXPECT_EQ(useful_threads(system, 1), 1);
    EXPECT_GE(threads, before);
    before = threads;
  }
  EXPECT_GT(before, 1);
}

TEST(SameBits, FreshResetAndResumed) {
  for (const char* integrator : implicit_schemes) {
    Scene scene = test::beam("tet4", 2);
    scene.time.integrator = integrator;
    scene.bodies[0].damping = {0.1, 1e-3};
    Stepped straight(scene);
    const State start = straight.state;
    straight.steps(7);
    const State saved = straight.state;
    straight.steps(8);

    Stepped resumed(scene);
    resumed.state = saved;
    resumed.steps(8);
    EXPECT_EQ(hash(straight.state), hash(resumed.state)) << integrator << ", resumed";

    const std::uint64_t first = hash(straight.state);
    straight.state = start;
    straight.steps(15);
    EXPECT_EQ(hash(straight.state), first) << integrator << ", reset";
  }
}

// A static step has no use for the force of a state: it is zero, not what memory held before.
TEST(SameBits, StaticStepsHaveThemToo) {
  Scene scene = test::free_body({"tri3", false}, "stvk");
  scene.time.integrator = "static";
  scene.bodies[0].pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, "xy", {}, {}, false}};
  const auto hash_after_a_step = [&](double filling) {
    std::vector<Eigen::VectorXd> memory;  // given back before the stepper takes its own
    for (int size = 1; size < 200; ++size) memory.push_back(Eigen::VectorXd::Constant(size, filling));
    memory.clear();
    Stepped run(scene);
    run.steps(1);
    EXPECT_TRUE(run.state.force.isZero(0));
    return hash(run.state);
  };
  EXPECT_EQ(hash_after_a_step(1), hash_after_a_step(2));
}

TEST(SameBits, HashSeesEveryBit) {
  Stepped run(test::beam("tet4", 1));
  run.steps(2);
  const std::uint64_t before = hash(run.state);
  run.state.v[5] = std::nextafter(run.state.v[5], 1e9);
  EXPECT_NE(hash(run.state), before);
}

TEST(Explicit, FormsNoMatrix) {
  Scene scene = test::beam("tet4", 2);
  scene.time.integrator = "symplectic-euler";
  scene.time.substeps = 0;
  Stepped run(scene);
  EXPECT_FALSE(parts_of(run.system).model.pattern.has_value());
  EXPECT_EQ(run.system.counts().nonzeros, 0);
  scene.time.integrator = "backward-euler";
  scene.solver.linear = LinearSolverKind::pcg;
  EXPECT_FALSE(parts_of(System(scene)).model.pattern.has_value()) << "matrix-free";
  scene.solver.linear = LinearSolverKind::cholmod;
  EXPECT_TRUE(parts_of(System(scene)).model.pattern.has_value());
}

TEST(Explicit, TakesTheStepsThatStabilityNeeds) {
  Scene scene = test::beam("tet4", 2);
  scene.time.integrator = "symplectic-euler";
  scene.time.substeps = 0;
  Stepped run(scene);
  const int n = run.system.steps_per_frame();
  EXPECT_GT(n, 1);
  EXPECT_LT(run.system.step_seconds(), run.system.stable_step());
  for (int k = 0; k < 30 * n; ++k) run.last = run.stepper->step(run.state);
  EXPECT_EQ(run.last.failure, "");
  EXPECT_GT(run.last.min_J, 0.5);
  // Twice the stable step explodes: the limit is not a guess on the safe side.
  scene.time.substeps = std::max(1, static_cast<int>(1 / (scene.time.fps * 2 * run.system.stable_step())));
  Stepped wild(scene);
  for (int k = 0; k < 400 && wild.last.failure.empty(); ++k) wild.last = wild.stepper->step(wild.state);
  EXPECT_TRUE(!wild.last.failure.empty() || wild.last.min_J < 0) << "a step beyond the limit was stable";
  EXPECT_TRUE(wild.state.x.allFinite()) << "the last good state is kept";
}

TEST(Pins, FollowTheirScriptAndLetGo) {
  Scene scene = test::beam("tet4", 1);
  Pin& pin = scene.bodies[0].pins[0];
  pin.motion = {{0, {0, 0, 0}, {1, 0, 0}, {0, 0.5, 0.5}, 0}, {0.5, {0.1, 0, 0.2}, {1, 0, 0}, {0, 0.5, 0.5}, 90}};
  pin.release = 0.5;
  Stepped run(scene);
  run.steps(15);  // t = 0.25: half-way
  const double c = std::sqrt(0.5);
  const Eigen::VectorXd& X = parts_of(run.system).model.X;
  int held = 0;
  for (const int node : run.system.pinned_nodes(0.25)) {
    const double y = X[3 * node + 1] - 0.5, z = X[3 * node + 2] - 0.5;
    EXPECT_NEAR(run.state.x[3 * node], 0.05, 1e-14);
    EXPECT_NEAR(run.state.x[3 * node + 1], 0.5 + c * (y - z), 1e-14);
    EXPECT_NEAR(run.state.x[3 * node + 2], 0.6 + c * (y + z), 1e-14);
    ++held;
  }
  EXPECT_EQ(held, 4);
  run.steps(30);  // t = 0.75: released at 0.5, it falls
  EXPECT_TRUE(run.system.pinned_nodes(0.75).empty());
  EXPECT_LT(run.system.measure(run.state).p.z(), -1000);
}

TEST(Solvers, AgreeWithEachOther) {
  Scene scene = test::beam("tet4", 2);
  scene.solver.tolerance = 1e-11;
  std::vector<Vec3> tips;
  for (const auto& [linear, name] : choices<LinearSolverKind>) {
    scene.solver.linear = linear;
    Stepped run(scene);
    run.steps(10);
    tips.push_back(run.tip());
    EXPECT_LT((tips.back() - tips.front()).norm(), 1e-9) << name;
  }
  EXPECT_GT(tips.front().norm(), 0.1);
}

TEST(BadScenes, NameTheKeyAtFault) {
  const auto key_of = [](const Scene& scene) -> std::string {
    try {
      System system(scene);
    } catch (const InputError& error) {
      return error.key;
    }
    return "accepted";
  };
  Scene scene = test::beam("tet4", 1);
  EXPECT_EQ(key_of(scene), "accepted");
  scene.bodies[0].pins[0].where = Sphere{{9, 9, 9}, 0.1};
  EXPECT_EQ(key_of(scene), "body.0.pin.0");
  scene = test::beam("tet4", 1);
  scene.probes[0].at = {4.1, 0.5, 0.5};
  EXPECT_EQ(key_of(scene), "probe.0.at");
  scene = test::beam("tet4", 1);
  scene.time.integrator = "euler";
  EXPECT_EQ(key_of(scene), "time.integrator");
}

TEST(Failures, LeaveTheStateAsItWas) {
  Scene scene = test::beam("tet4", 1);
  Stepped run(scene);
  run.steps(2);
  run.state.v[20] = 1e300;
  const std::uint64_t before = hash(run.state);
  const StepReport report = run.stepper->step(run.state);
  EXPECT_NE(report.failure, "");
  EXPECT_EQ(hash(run.state), before);
}

}  // namespace
}  // namespace sim
