// A session without a window: inputs between steps, history, changes while the bodies move.
#include "app/session/session.h"

#include "app/base/exit_code.h"
#include "app/base/text.h"
#include "app/command/commands.h"
#include "app/run/state_file.h"
#include "app/scene/scene_text.h"
#include "tests/app/session_scene.h"

namespace app {
namespace {

using SessionTest = SessionScene;

// Mean height of the nodes [m].
double height_of(const Session& session) {
  const Eigen::Map<const Eigen::Matrix3Xd> x(session.state().x.data(), 3, session.state().x.size() / 3);
  return x.row(1).mean();
}

TEST_F(SessionTest, WithoutInputsItIsTheRunOfTheCommand) {
  Options plain = options();
  plain.out = folder_ / "run";
  ASSERT_EQ(run(plain), exit_done);
  Session session(options());
  take(session, 20);
  EXPECT_EQ(hash_of(session), sim::hash(read_state_file(folder_ / "run/state.bin").state));
}

TEST_F(SessionTest, StepsBackToTheSameBitsAndOnAgain) {
  for (const char* linear : {"cholmod", "auto", "pcg"}) {
    Options chosen = options();
    chosen.overrides = {{"solver.linear", linear, "test"}};
    Session session(chosen);
    take(session, 5);
    const std::uint64_t five = hash_of(session);
    take(session, 4);
    const std::uint64_t nine = hash_of(session);
    for (int k = 0; k < 4; ++k) session.apply(StepBack{});
    EXPECT_EQ(hash_of(session), five) << linear;
    take(session, 4);
    EXPECT_EQ(hash_of(session), nine) << linear;
    EXPECT_EQ(session.steps(), 13);
  }
}

TEST_F(SessionTest, StepBackAtTheStartDoesNothing) {
  Session session(options());
  const std::uint64_t start = hash_of(session);
  session.apply(StepBack{});
  EXPECT_EQ(hash_of(session), start);
}

TEST_F(SessionTest, ResetIsTheInitialStateWithTheValuesAsTheyAre) {
  Session session(options());
  take(session, 3);
  session.apply(SetKey{"world.gravity", "[0, -1, 0]"});
  session.apply(Reset{});
  EXPECT_EQ(session.state().step, 0);
  EXPECT_EQ(session.history(), 0U);
  take(session, 4);
  Options moon = options();
  moon.overrides = {{"world.gravity", "[0, -1, 0]", "test"}};
  Session other(moon);
  take(other, 4);
  EXPECT_EQ(hash_of(session), hash_of(other));
}

TEST_F(SessionTest, ALiveChangeGoesOnFromWhereTheBodiesAre) {
  Session session(options()), unchanged(options());
  take(session, 6);
  take(unchanged, 6);
  const sim::State before = session.state();
  session.apply(SetKey{"body.0.material.young", "1e3"});
  EXPECT_EQ(session.state().x, before.x);
  EXPECT_EQ(session.state().v, before.v);
  EXPECT_EQ(session.state().step, before.step);
  take(session, 6);
  take(unchanged, 6);
  EXPECT_LT(height_of(session), height_of(unchanged) - 0.01) << "softer, it hangs lower";
}

// A change that is none must not move a bit: what is carried over is all that the scheme needs.
TEST_F(SessionTest, AChangeToTheSameValueKeepsTheTrajectory) {
  for (const char* integrator : {"backward-euler", "bdf2", "symplectic-euler", "implicit-midpoint"}) {
    Options chosen = options();
    chosen.overrides = {{"time.integrator", integrator, "test"}};
    Session session(chosen), unchanged(chosen);
    take(session, 6);
    take(unchanged, 6);
    session.apply(SetKey{"body.0.material.young", "1e5"});
    take(session, 3);
    take(unchanged, 3);
    const double size = unchanged.state().x.norm();
    EXPECT_LT((session.state().x - unchanged.state().x).norm(), 1e-7 * size) << integrator;
  }
}

TEST_F(SessionTest, AnotherStepBeginsWhereItMeetsTheTime) {
  Session session(options());
  take(session, 3);  // t = 3/40
  session.apply(SetKey{"time.substeps", "3"});
  EXPECT_DOUBLE_EQ(session.simulation()->system->step_seconds(), 1.0 / 40) << "3/40 is no multiple of 1/60";
  take(session, 1);  // t = 4/40 = 6/60
  EXPECT_DOUBLE_EQ(session.simulation()->system->step_seconds(), 1.0 / 60);
  EXPECT_EQ(session.state().step, 6);
  EXPECT_DOUBLE_EQ(session.simulation()->system->time(session.state().step), 0.1);
  session.apply(SetKey{"time.substeps", "6"});
  EXPECT_EQ(session.state().step, 12) << "it divides: at once";
  take(session, 1);
}

TEST_F(SessionTest, LooksChangeWithoutANewSystem) {
  Session session(options());
  take(session, 2);
  const auto before = session.simulation();
  session.apply(SetKey{"look.wireframe", "true"});
  session.apply(MoveCamera{sim::Vec3(1, 2, 9), sim::Vec3(1, 0, 0), {}});
  EXPECT_EQ(session.simulation()->system, before->system);
  EXPECT_TRUE(session.simulation()->document.look.wireframe);
  EXPECT_EQ(*session.simulation()->document.camera.eye, sim::Vec3(1, 2, 9));
  session.apply(SetKey{"look.wireframe", "false"});
  EXPECT_EQ(*session.document().camera.eye, sim::Vec3(1, 2, 9)) << "the camera stays where it was moved";
}

TEST_F(SessionTest, AMeshWaitsForTheRestart) {
  Session session(options());
  take(session, 3);
  const auto nodes = session.state().x.size();
  session.apply(SetKey{"body.0.mesh.cells", "[6, 2, 2]"});
  ASSERT_EQ(session.waiting().size(), 1U);
  EXPECT_EQ(session.waiting()[0].key, "body.0.mesh.cells");
  EXPECT_EQ(session.state().x.size(), nodes);
  take(session, 1);
  session.apply(Restart{});
  EXPECT_TRUE(session.waiting().empty());
  EXPECT_GT(session.state().x.size(), nodes);
  EXPECT_EQ(session.state().step, 0);
  take(session, 1);
}

TEST_F(SessionTest, WhatIsRefusedChangesNothing) {
  Session session(options());
  take(session, 2);
  const std::uint64_t before = hash_of(session);
  const auto simulation = session.simulation();
  EXPECT_NE(error_of([&] {
              session.apply(SetKey{"body.0.material.poisson", "0.7"});
            }).find("in (-1, 0.5)"),
            std::string::npos);
  EXPECT_NE(error_of([&] { session.apply(SetKey{"body.0.mesh.cells", "[6, 2]"}); }), "");
  EXPECT_NE(error_of([&] { session.apply(SetKey{"body.7.material.young", "1"}); }), "");
  EXPECT_NE(error_of([&] { session.apply(SetKey{"boddy", "1"}); }).find("no such key"), std::string::npos);
  EXPECT_NE(error_of([&] { session.apply(Pull{"nobody", {0, 0, 0}, {0, 0, 0}}); }).find("nobody"), std::string::npos);
  EXPECT_NE(error_of([&] { session.apply(Pull{"beam", {9, 9, 9}, {0, 0, 0}}); }), "");
  EXPECT_EQ(hash_of(session), before);
  EXPECT_EQ(session.simulation(), simulation);
  EXPECT_TRUE(session.waiting().empty());
}

int springs(const Session& session) {
  int count = 0;
  for (const sim::TermInfo& term : session.simulation()->system->terms()) count += term.name.starts_with("spring");
  return count;
}

TEST_F(SessionTest, TheSpringExistsWhileThePullLasts) {
  Session session(options()), free(options());
  EXPECT_EQ(springs(session), 0);
  session.apply(Pull{"beam", {2, 0.5, 0.5}, {2, 0.5, 0.5}});
  EXPECT_EQ(springs(session), 1);
  session.apply(PullTo{{2, 2, 0.5}});
  take(session, 8);
  take(free, 8);
  EXPECT_GT(height_of(session), height_of(free) + 0.05);
  session.apply(Release{});
  EXPECT_EQ(springs(session), 0);
  session.apply(PullTo{{9, 9, 9}});
  EXPECT_EQ(springs(session), 0) << "nothing is held";
  EXPECT_EQ(session.document().scene.springs.size(), 0U);
}

TEST_F(SessionTest, AFailedStepLeavesTheLastGoodState) {
  Options wild = options();
  wild.overrides = {{"time.integrator", "symplectic-euler", "test"},
                    {"time.substeps", "1", "test"},
                    {"body.0.material.young", "1e9", "test"}};
  Session session(wild);
  sim::StepReport report;
  int steps = 0;
  while (report.failure.empty() && steps < 1000) {
    report = session.step();
    ++steps;
  }
  ASSERT_NE(report.failure, "");
  EXPECT_TRUE(session.state().x.allFinite());
  EXPECT_EQ(session.steps(), steps - 1);
  const std::uint64_t before = hash_of(session);
  EXPECT_NE(session.step().failure, "");
  EXPECT_EQ(hash_of(session), before);
  session.apply(Reset{});
  EXPECT_EQ(session.step().failure, "");
}

TEST_F(SessionTest, ASavedSceneReproducesTheState) {
  Session session(options());
  take(session, 5);
  session.apply(SetKey{"body.0.material.young", "3e4"});
  session.apply(SetKey{"body.0.damping.beta", "0.01"});
  session.apply(SetKey{"time.integrator", "\"bdf2\""});
  session.apply(SetKey{"body.0.mesh.cells", "[5, 2, 2]"});
  session.apply(MoveCamera{sim::Vec3(3, 1, 8), sim::Vec3(1, 0, 0), {}});
  session.apply(Restart{});
  take(session, 20);
  write_all(folder_ / "saved.toml", scene_toml(session.document(), folder_.path()));
  Options again = options("saved.toml");
  again.out = folder_ / "again";
  ASSERT_EQ(record(again), exit_done);
  EXPECT_EQ(hash_of(session), sim::hash(read_state_file(folder_ / "again/state.bin").state));
}

TEST_F(SessionTest, TheHistoryIsBounded) {
  History history;
  sim::State state;
  state.x = Eigen::VectorXd::Zero(30000);
  for (int k = 0; k < 3000; ++k) {
    state.step = k;
    history.push(state);
  }
  const std::size_t held = history.size();
  EXPECT_LE(held * 9 * 30000 * sizeof(double), History::bytes);
  EXPECT_GT(held, 100U);
  for (std::size_t k = 0; k < held; ++k) EXPECT_EQ(history.pop()->step, 2999 - static_cast<std::int64_t>(k));
  EXPECT_FALSE(history.pop());
}

TEST(Effect, EveryKeyHasTheOneThatItsTableSays) {
  for (const auto& [path, effect] : {std::pair("look.colour", Effect::look),
                                     std::pair("camera.target", Effect::look),
                                     std::pair("camera.keyframes[].1.turn", Effect::look),
                                     std::pair("body[].mesh.cells", Effect::restart),
                                     std::pair("body[].mesh.rotate.axis", Effect::restart),
                                     std::pair("time.fps", Effect::restart),
                                     std::pair("body[].name", Effect::restart),
                                     std::pair("body[].region[].group", Effect::restart),
                                     std::pair("body[].velocity", Effect::start),
                                     std::pair("body[].spin.rate", Effect::start),
                                     std::pair("body[].start.shape", Effect::start),
                                     std::pair("body[].start.perturbation", Effect::start),
                                     std::pair("seed", Effect::start),
                                     std::pair("body[].untangle", Effect::motion),
                                     std::pair("time.integrator", Effect::motion),
                                     std::pair("time.step", Effect::motion),
                                     std::pair("solver.linear", Effect::motion),
                                     std::pair("world.gravity", Effect::motion),
                                     std::pair("body[].material.model", Effect::motion),
                                     std::pair("body[].damping.beta", Effect::motion),
                                     std::pair("body[].pin[].release", Effect::motion),
                                     std::pair("obstacle[].friction", Effect::motion)})
    EXPECT_EQ(find_key(path)->effect, effect) << path;
}

// What the panel says of such a key is what happens: nothing that is seen until the reset.
TEST_F(SessionScene, AKeyOfTheStartTellsAtTheReset) {
  for (const auto& [key, value] : {std::pair("body.0.start.shape", "\"twisted\""), std::pair("seed", "7"),
                                   std::pair("body.0.start.perturbation", "0.02"),
                                   std::pair("body.0.velocity", "[0, 0, 1]"), std::pair("body.0.spin.rate", "3")}) {
    SCOPED_TRACE(key);
    Indices indices{};
    ASSERT_EQ(find_key_at(key, indices)->effect, Effect::start);
    Session session(options());
    session.apply(SetKey{"body.0.start.perturbation", "0.01"});  // so that the seed has something to decide
    session.apply(Reset{});
    const std::uint64_t begun = hash_of(session);
    take(session, 3);
    const Eigen::VectorXd x = session.state().x, v = session.state().v;
    session.apply(SetKey{key, value});
    EXPECT_EQ(session.state().x, x);
    EXPECT_EQ(session.state().v, v);
    session.apply(Reset{});
    EXPECT_NE(hash_of(session), begun);
  }
}

}  // namespace
}  // namespace app
