// Bases as scene files have them: keys, the run that they come from, what is refused, what a state keeps.
#include "app/mesh/vtu.h"
#include "app/picture/frame_history.h"
#include "app/run/state_file.h"
#include "app/run/vtu.h"
#include "app/scene/scene_identity.h"
#include "app/scene/scene_text.h"
#include "app/scene/simulation.h"
#include "app/scene/snapshots.h"
#include "app/session/session.h"
#include "sim/stepper.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

class BasisScenes : public SceneFile {
 protected:
  static std::string beam(const std::string& basis) {
    return "[[body]]\nname = \"beam\"\nmesh = { rectangle = [4, 1], cells = [8, 2] }\nmaterial = { young = 1e6 }\n"
           "pin = [{ group = \"left\" }]\n" +
           (basis.empty() ? "" : "basis = { " + basis + " }\n");
  }
  Simulation simulation(const std::string& text, const std::vector<Override>& overrides = {}) const {
    Options options;
    options.scene = file("scene.toml", text);
    options.overrides = overrides;
    return build_simulation(options);
  }
  // A run of so many frames, as far as its VTU files.
  void run(const Simulation& simulation, const std::string& folder, int frames) const {
    std::filesystem::create_directories(folder_ / folder / "vtu");
    const auto stepper = sim::make_stepper(*simulation.system, 1);
    sim::State state = simulation.system->initial_state();
    for (int k = 0; k <= frames; ++k) {
      if (k > 0) stepper->step(state);
      write_all(folder_ / folder / "vtu" / ("frame_0000" + std::to_string(k) + ".vtu"),
                vtu_text(*simulation.system, state));
    }
  }
};

TEST_F(BasisScenes, HaveKindCountAndCubature) {
  const Document document = load(beam("kind = \"modes\", count = 7, cubature = 0.02"));
  const sim::Basis& basis = *document.scene.bodies[0].basis;
  EXPECT_EQ(basis.kind, sim::BasisKind::modes);
  EXPECT_EQ(basis.count, 7);
  EXPECT_EQ(basis.cubature, 0.02);
  EXPECT_EQ(load(beam("kind = \"derivatives\"")).scene.bodies[0].basis->count, 20);
  EXPECT_FALSE(load(beam("")).scene.bodies[0].basis);
  const Document without = load(beam("kind = \"modes\", count = 7"), {set("body.0.basis.kind", "none")});
  EXPECT_FALSE(without.scene.bodies[0].basis);
  EXPECT_EQ(scene_identity(without), scene_identity(load(beam(""))));
  EXPECT_EQ(load(beam(""), {set("body.0.basis.kind", "modes")}).scene.bodies[0].basis->kind, sim::BasisKind::modes);
}

TEST_F(BasisScenes, AreWrittenAsTheyWereRead) {
  const Document document = load(beam("kind = \"modes\", count = 7, cubature = 0.02"));
  const Document again = load(scene_toml(document, folder_.path()));
  EXPECT_EQ(scene_json(again, {}), scene_json(document, {}));
  EXPECT_NE(scene_identity(document), scene_identity(load(beam("kind = \"modes\", count = 8"))));
}

TEST_F(BasisScenes, MistakesAreNamedWithTheirLine) {
  EXPECT_NE(error(beam("kind = \"mode\"")).find("scene.toml:6"), std::string::npos);
  EXPECT_NE(error(beam("kind = \"mode\"")).find("\"modes\""), std::string::npos);
  EXPECT_NE(error(beam("count = 3")).find("'kind' is missing"), std::string::npos);
  EXPECT_NE(error(beam("kind = \"modes\", count = 0")).find("[1, 1000]"), std::string::npos);
  EXPECT_NE(error(beam("kind = \"snapshots\", from = \"nowhere\"")).find("there is no such folder"), std::string::npos);
  const auto refused = [&](const std::string& text) { return error_of([&] { simulation(text); }); };
  EXPECT_NE(refused(beam("kind = \"snapshots\"")).find("scene.toml:6"), std::string::npos);
  EXPECT_NE(refused(beam("kind = \"snapshots\"")).find("the run folder whose states make the basis"),
            std::string::npos);
  const std::string released =
      error_of([&] { simulation(beam("kind = \"modes\""), {set("body.0.pin.0.release", "1.0")}); });
  EXPECT_NE(released.find("holds pins for good"), std::string::npos) << released;
}

// What a run has gone through makes a basis in which the same scene goes the same way.
TEST_F(BasisScenes, OfARunGoTheWayOfTheRun) {
  const Simulation full = simulation(beam(""));
  run(full, "full", 9);
  EXPECT_EQ(snapshot_frames(folder_ / "full"), (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  const Simulation reduced = simulation(beam("kind = \"snapshots\", count = 8, from = \"full\""));
  ASSERT_EQ(reduced.document.scene.bodies[0].basis->snapshots->cols(), 10);
  const auto a = sim::make_stepper(*full.system, 1), b = sim::make_stepper(*reduced.system, 1);
  sim::State x = full.system->initial_state(), y = reduced.system->initial_state();
  for (int k = 0; k < 9; ++k) {
    a->step(x);
    b->step(y);
  }
  const double moved = (x.x - full.system->initial_state().x).cwiseAbs().maxCoeff();
  EXPECT_LT((x.x - y.x).cwiseAbs().maxCoeff(), 1e-3 * moved);
  const std::string other = beam("kind = \"snapshots\", count = 8, from = \"full\"");
  EXPECT_NE(
      error_of([&] { simulation(other, {set("body.0.mesh.cells", "[4, 2]")}); }).find("it is the run of another mesh"),
      std::string::npos);
}

TEST_F(BasisScenes, StatesKeepTheirCoordinatesInFiles) {
  const Simulation reduced = simulation(beam("kind = \"derivatives\", count = 5"));
  const auto stepper = sim::make_stepper(*reduced.system, 1);
  SavedRun saved;
  saved.state = reduced.system->initial_state();
  for (int k = 0; k < 3; ++k) stepper->step(saved.state);
  ASSERT_EQ(saved.state.coordinates.c.size(), 5);
  const SavedRun again = decode(encode(saved), "state.bin");
  EXPECT_EQ(sim::hash(again.state), sim::hash(saved.state));
  saved.state.coordinates.rate.resize(4);
  EXPECT_THROW(decode(encode(saved), "state.bin"), std::runtime_error);
}

// More vectors, fewer, or all nodes, while the body moves: it goes on from where it is, as near as the vectors allow.
TEST_F(BasisScenes, CountAndKindChangeWhileTheBodyMoves) {
  for (const char* integrator : {"trapezoidal", "central-difference"}) {
    Options options;
    options.scene = file("scene.toml", beam("kind = \"derivatives\", count = 5"));
    options.overrides = {set("time.integrator", integrator)};
    Session session(options);
    const auto go_on = [&](const char* key, const char* value) {
      const Eigen::VectorXd before = session.state().x;
      session.apply(SetKey{key, value});
      // Where steps become longer or shorter it waits for the next frame.
      do EXPECT_EQ(session.step().failure, "");
      while (session.state().step % session.simulation()->system->steps_per_frame() != 0);
      EXPECT_EQ(session.step().failure, "");
      EXPECT_LT((session.state().x - before).cwiseAbs().maxCoeff(), 0.2) << value;
      return session.state().coordinates.c.size();
    };
    for (int k = 0; k < 10; ++k) session.step();
    EXPECT_EQ(session.state().coordinates.c.size(), 5);
    EXPECT_EQ(go_on("body.0.basis.count", "9"), 9);
    EXPECT_EQ(go_on("body.0.basis.count", "3"), 3);
    EXPECT_EQ(go_on("body.0.basis.kind", "\"none\""), 0);
    EXPECT_EQ(go_on("body.0.basis.kind", "\"modes\""), 3);
    EXPECT_TRUE(session.waiting().empty());
  }
}

// The ghost is stepped in all nodes, to the bit as the scene without a basis; one that goes back starts there anew.
TEST_F(BasisScenes, GhostsAreTheBodiesInAllOfTheirNodes) {
  const std::vector<Override> ghost = {set("look.ghost", "true")};
  const Simulation reduced = simulation(beam("kind = \"modes\", count = 4"), ghost), full = simulation(beam(""), ghost);
  FrameHistory history(reduced), of_full(full);
  const auto a = sim::make_stepper(*reduced.system, 1), b = sim::make_stepper(*full.system, 1);
  sim::State x = reduced.system->initial_state(), y = full.system->initial_state(), early;
  LargestShown largest{};
  const auto seen = [&](const FrameHistory& frames) {
    Moment moment{.frame = x.step, .state = x};
    frames.fill(largest, moment);
    return moment.full;
  };
  for (int k = 0; k <= 20; ++k) {
    if (k > 0) a->step(x), b->step(y);
    if (k == 7) early = x;
    history.add(x, largest);
    of_full.add(y, largest);
    EXPECT_EQ(seen(history), y.x) << k;
  }
  EXPECT_GT((x.x - y.x).cwiseAbs().maxCoeff(), 0.05) << "modes are too stiff";
  EXPECT_EQ(seen(of_full).size(), 0) << "nothing is stepped beside what has no basis";
  history.add(early, largest);
  EXPECT_EQ(seen(history), early.x);
}

// Pulling at a body builds its system anew, and not its basis.
TEST_F(BasisScenes, ServeAgainWhereTheBodyIsTheSame) {
  const Simulation first = simulation(beam("kind = \"derivatives\", count = 5"));
  Simulation same, other;
  same.document = load(beam("kind = \"derivatives\", count = 5"));
  other.document = load(beam("kind = \"derivatives\", count = 6"));
  make_bases(same, &first, {}, 1);
  make_bases(other, &first, {}, 1);
  EXPECT_EQ(same.document.scene.bodies[0].basis->vectors, first.document.scene.bodies[0].basis->vectors);
  EXPECT_EQ(other.document.scene.bodies[0].basis->vectors->U.cols(), 6);
}

}  // namespace
}  // namespace app
