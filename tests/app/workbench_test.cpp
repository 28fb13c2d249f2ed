// Keys and mouse without a window.
#include "app/view/camera_moves.h"
#include "tests/app/workbench_scene.h"

namespace app {
namespace {

using render::WindowEvent;

TEST_F(WorkbenchTest, KeysStepBackAndReset) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  key(bench, render::Key::right);
  key(bench, render::Key::right);
  EXPECT_EQ(bench.session().state().step, 2);
  key(bench, render::Key::left);
  EXPECT_EQ(bench.session().state().step, 1);
  key(bench, render::Key::backspace);
  EXPECT_EQ(bench.session().state().step, 0);
  EXPECT_EQ(bench.session().steps(), 2);
}

TEST_F(WorkbenchTest, PlaysAtTheRateOfTheWallClock) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  bench.advance(1);
  EXPECT_EQ(bench.session().steps(), 0) << "it begins paused";
  key(bench, render::Key::space);
  bench.advance(0.01);
  EXPECT_EQ(bench.session().steps(), 0) << "a step is 1/40 s";
  bench.advance(0.02);
  EXPECT_EQ(bench.session().steps(), 1);
  key(bench, render::Key::space);
  bench.advance(1);
  EXPECT_EQ(bench.session().steps(), 1);
}

TEST(Pace, KeepsToTheClockAndSaysWhereItCannot) {
  Pace pace;
  int steps = 0;
  for (int k = 0; k < 100; ++k) {
    pace.pass(0.033, 0.01);
    for (; pace.due(0.01); ++steps) pace.stepped(0.01);
  }
  EXPECT_NEAR(steps, 330, 2);
  EXPECT_GT(pace.factor(), 0.95);
  Pace slow;
  for (int k = 0; k < 100; ++k) {
    slow.pass(0.1, 0.01);  // one step takes a tenth of a second
    slow.stepped(0.01);
  }
  EXPECT_NEAR(slow.factor(), 0.1, 0.02);
}

TEST_F(WorkbenchTest, TypingAndThePanelAreLeftAlone) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  WindowEvent space{WindowEvent::Kind::key, render::Key::right};
  bench.handle(space, frame_width, frame_height, true);
  EXPECT_EQ(bench.session().steps(), 0);
  const render::Camera before = bench.frame(frame_width, frame_height).camera;
  WindowEvent wheel{WindowEvent::Kind::scroll};
  wheel.scroll = 3;
  bench.handle(wheel, frame_width, frame_height, true);
  EXPECT_EQ(bench.frame(frame_width, frame_height).camera.eye, before.eye);
  WindowEvent quit{WindowEvent::Kind::key, render::Key::letter, 'Q'};
  quit.control = true;
  bench.handle(quit, frame_width, frame_height, true);
  EXPECT_TRUE(bench.quits());
}

TEST_F(WorkbenchTest, TheMouseMovesTheCamera) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  const render::Camera first = bench.frame(frame_width, frame_height).camera;
  const auto length = [](const render::Camera& c) {
    return std::hypot(c.eye[0] - c.target[0], c.eye[1] - c.target[1], c.eye[2] - c.target[2]);
  };
  drag(bench, 80, 60, 110, 50, render::Button::left);
  const render::Camera orbited = bench.frame(frame_width, frame_height).camera;
  EXPECT_NE(orbited.eye, first.eye);
  EXPECT_EQ(orbited.target, first.target);
  EXPECT_NEAR(length(orbited), length(first), 1e-4 * length(first));
  // What was under the mouse follows it.
  const sim::Vec3 target(orbited.target[0], orbited.target[1], orbited.target[2]);
  drag(bench, 80, 60, 100, 70, render::Button::right);
  const Eigen::Vector3f now = place(bench, target);
  EXPECT_NEAR(now.x(), 100, 0.5);
  EXPECT_NEAR(now.y(), 70, 0.5);
  WindowEvent wheel{WindowEvent::Kind::scroll};
  wheel.scroll = 2;
  bench.handle(wheel, frame_width, frame_height, false);
  EXPECT_NEAR(length(bench.frame(frame_width, frame_height).camera), 0.81 * length(orbited), 1e-3 * length(orbited));
  // The picture made anew for that camera is the same.
  key(bench, render::Key::letter, false, 'W');
  const render::Camera after = bench.frame(frame_width, frame_height).camera;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(after.eye[i], bench.session().document().camera.eye->coeff(i), 1e-5);
}

TEST_F(WorkbenchTest, AnOrbitStopsShortOfThePole) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  for (int k = 0; k < 20; ++k) drag(bench, 80, 10, 80, 110, render::Button::left);
  const render::Camera camera = bench.frame(frame_width, frame_height).camera;
  EXPECT_NO_THROW(render::make_view(camera, 1, {}));
}

TEST_F(WorkbenchTest, ControlAndDragPullTheBody) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  const sim::Vec3 corner(2, 1, 1);
  const Eigen::Vector3f at = place(bench, corner);
  mouse(bench, WindowEvent::Kind::press, at.x() - 1, at.y() + 2, render::Button::left, true);
  ASSERT_TRUE(bench.session().pull());
  const sim::Vec3 held = bench.session().pull()->at;
  EXPECT_LT((held - corner).norm(), 0.6) << held.transpose();
  mouse(bench, WindowEvent::Kind::move, at.x() - 1, at.y() - 40, render::Button::left, true);
  for (int k = 0; k < 10; ++k) key(bench, render::Key::right);
  EXPECT_GT(bench.session().pull()->target.y(), 1.2) << "it pulls up";
  Session left_alone(options());
  take(left_alone, 10);
  const auto height = [](const Session& session) { return session.state().x.tail(2)[0]; };  // of the corner
  EXPECT_GT(height(bench.session()), height(left_alone) + 0.02);
  EXPECT_FALSE(bench.frame(frame_width, frame_height).arrows.empty()) << "the spring is drawn";
  mouse(bench, WindowEvent::Kind::release, at.x(), at.y() - 40, render::Button::left);
  EXPECT_FALSE(bench.session().pull());
  // Beside the body there is nothing to pull.
  mouse(bench, WindowEvent::Kind::press, 1, 1, render::Button::left, true);
  EXPECT_FALSE(bench.session().pull());
}

TEST_F(WorkbenchTest, SavesAndReadsAgain) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  letter(bench, 'W', false);
  EXPECT_TRUE(bench.session().document().look.wireframe);
  letter(bench, 'S', true);
  EXPECT_NE(read_all(folder_ / "beam-1.toml").find("wireframe = true"), std::string::npos) << bench.message();
  letter(bench, 'S', true);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "beam-2.toml")) << "nothing is overwritten";
  key(bench, render::Key::right);
  write_all(folder_ / "beam.toml", std::string(session_beam) + "[world]\ngravity = [0, 0, 0]\n");
  letter(bench, 'L', true);
  EXPECT_EQ(bench.session().document().scene.world.gravity.y(), 0);
  EXPECT_EQ(bench.session().steps(), 0);
  EXPECT_FALSE(bench.session().document().look.wireframe);
  EXPECT_NE(read_all(folder_ / "session.toml").find("look.wireframe"), std::string::npos) << "the log is kept";
  EXPECT_NE(read_all(folder_ / "session.toml").find("steps = 1"), std::string::npos) << "and ended";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "session-1.toml")) << bench.message();
  // A file that cannot be read leaves what is shown.
  write_all(folder_ / "beam.toml", "[[body]]\n");
  letter(bench, 'L', true);
  EXPECT_NE(bench.message().find("beam.toml"), std::string::npos);
  key(bench, render::Key::right);
  EXPECT_EQ(bench.session().steps(), 1);
}

TEST_F(WorkbenchTest, AFailureIsShownAndTheStateStays) {
  Options wild = logged();
  wild.overrides = {{"time.integrator", "symplectic-euler", "test"},
                    {"time.substeps", "1", "test"},
                    {"body.0.material.young", "1e9", "test"}};
  Workbench bench(wild, std::make_unique<Session>(wild));
  key(bench, render::Key::space);
  for (int k = 0; k < 2000 && bench.playing(); ++k) bench.advance(0.1);
  EXPECT_FALSE(bench.playing());
  EXPECT_NE(bench.message().find("cannot be taken"), std::string::npos) << bench.message();
  for (const render::Surface& surface : bench.frame(frame_width, frame_height).surfaces) {
    for (const float x : surface.positions) ASSERT_TRUE(std::isfinite(x));
  }
}

TEST_F(WorkbenchTest, AnExistingLogIsNotOverwritten) {
  write_all(folder_ / "session.toml", "precious");
  EXPECT_NE(error_of([&] { Workbench bench(logged(), std::make_unique<Session>(logged())); }).find("--overwrite"),
            std::string::npos);
  EXPECT_EQ(read_all(folder_ / "session.toml"), "precious");
}

}  // namespace
}  // namespace app
