// Keys and mouse without a window, the log that they leave, and its replay.
#include "app/window/workbench.h"

#include "app/commands.h"
#include "app/hexadecimal.h"
#include "app/session/session_file.h"
#include "app/state_file.h"
#include "app/window/camera_moves.h"
#include "render/view.h"
#include "tests/app/session_scene.h"

namespace app {
namespace {

using render::WindowEvent;

class WorkbenchTest : public SessionScene {
 protected:
  static constexpr int kWidth = 160, kHeight = 120;

  Options logged() const {
    Options with_log = options();
    with_log.log = folder_ / "session.toml";
    with_log.out = folder_.path();
    return with_log;
  }
  static void key(Workbench& bench, render::Key key, bool control = false, char letter = 0) {
    WindowEvent event{WindowEvent::Kind::key, key, letter};
    event.control = control;
    bench.handle(event, kWidth, kHeight, false);
  }
  static void letter(Workbench& bench, char letter, bool control) { key(bench, render::Key::letter, control, letter); }
  static void mouse(Workbench& bench, WindowEvent::Kind kind, float x, float y, render::Button button,
                    bool control = false) {
    WindowEvent event{kind};
    event.x = x;
    event.y = y;
    event.button = button;
    event.control = control;
    bench.handle(event, kWidth, kHeight, false);
  }
  static void drag(Workbench& bench, float x0, float y0, float x1, float y1, render::Button button) {
    mouse(bench, WindowEvent::Kind::press, x0, y0, button);
    mouse(bench, WindowEvent::Kind::move, x1, y1, button);
    mouse(bench, WindowEvent::Kind::release, x1, y1, button);
  }
  // Where a point of the scene is in the picture.
  static Eigen::Vector3f place(Workbench& bench, const sim::Vec3& point) {
    const render::Frame& frame = bench.frame(kWidth, kHeight);
    const render::View view = render::make_view(frame.camera, float(kWidth) / kHeight, render::bounds_of(frame));
    return view.to_window(point.cast<float>(), kWidth, kHeight);
  }
  static double distance(const Workbench& bench, const sim::Vec3& point) {
    const sim::State& state = bench.session().state();
    const auto last = static_cast<Eigen::Index>(state.x.size()) - 3;  // the corner (2, 1, 1)
    return (state.x.segment(last, 3) - point).norm();
  }
};

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
  bench.handle(space, kWidth, kHeight, true);
  EXPECT_EQ(bench.session().steps(), 0);
  const render::Camera before = bench.frame(kWidth, kHeight).camera;
  WindowEvent wheel{WindowEvent::Kind::scroll};
  wheel.scroll = 3;
  bench.handle(wheel, kWidth, kHeight, true);
  EXPECT_EQ(bench.frame(kWidth, kHeight).camera.eye, before.eye);
  WindowEvent quit{WindowEvent::Kind::key, render::Key::letter, 'Q'};
  quit.control = true;
  bench.handle(quit, kWidth, kHeight, true);
  EXPECT_TRUE(bench.quits());
}

TEST_F(WorkbenchTest, TheMouseMovesTheCamera) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  const render::Camera first = bench.frame(kWidth, kHeight).camera;
  const auto length = [](const render::Camera& c) {
    return std::hypot(c.eye[0] - c.target[0], c.eye[1] - c.target[1], c.eye[2] - c.target[2]);
  };
  drag(bench, 80, 60, 110, 50, render::Button::left);
  const render::Camera orbited = bench.frame(kWidth, kHeight).camera;
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
  bench.handle(wheel, kWidth, kHeight, false);
  EXPECT_NEAR(length(bench.frame(kWidth, kHeight).camera), 0.81 * length(orbited), 1e-3 * length(orbited));
  // The picture made anew for that camera is the same.
  key(bench, render::Key::letter, false, 'W');
  const render::Camera after = bench.frame(kWidth, kHeight).camera;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(after.eye[i], bench.session().document().camera.eye->coeff(i), 1e-5);
}

TEST_F(WorkbenchTest, AnOrbitStopsShortOfThePole) {
  Workbench bench(logged(), std::make_unique<Session>(logged()));
  for (int k = 0; k < 20; ++k) drag(bench, 80, 10, 80, 110, render::Button::left);
  const render::Camera camera = bench.frame(kWidth, kHeight).camera;
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
  const double pulled = bench.session().state().x.maxCoeff();
  EXPECT_GT(pulled, 2.0 - 1e-6);
  EXPECT_FALSE(bench.frame(kWidth, kHeight).arrows.empty()) << "the spring is drawn";
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
  write_all(folder_ / "beam.toml", std::string(kSessionBeam) + "[world]\ngravity = [0, 0, 0]\n");
  letter(bench, 'L', true);
  EXPECT_EQ(bench.session().document().scene.world.gravity.y(), 0);
  EXPECT_EQ(bench.session().steps(), 0);
  EXPECT_FALSE(bench.session().document().look.wireframe);
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
  for (const render::Surface& surface : bench.frame(kWidth, kHeight).surfaces) {
    for (const float x : surface.positions) ASSERT_TRUE(std::isfinite(x));
  }
}

TEST_F(WorkbenchTest, AnExistingLogIsNotOverwritten) {
  write_all(folder_ / "session.toml", "precious");
  EXPECT_NE(error_of([&] { Workbench bench(logged(), std::make_unique<Session>(logged())); }).find("--overwrite"),
            std::string::npos);
  EXPECT_EQ(read_all(folder_ / "session.toml"), "precious");
}

std::string hash_in(const std::filesystem::path& run_json) {
  const std::string text = read_all(run_json), key = "\"state_hash\": \"";
  const std::size_t at = text.find(key);
  return at == std::string::npos ? "" : text.substr(at + key.size(), 16);
}

class Replay : public WorkbenchTest {
 protected:
  // A session in which everything happens; returns the hash it ends with.
  std::string act() {
    Workbench bench(logged(), std::make_unique<Session>(logged()));
    bench.frame(kWidth, kHeight);
    for (int k = 0; k < 5; ++k) key(bench, render::Key::right);
    drag(bench, 80, 60, 100, 55, render::Button::left);
    letter(bench, 'W', false);
    const Eigen::Vector3f at = place(bench, {2, 1, 1});
    mouse(bench, WindowEvent::Kind::press, at.x() - 2, at.y() + 8, render::Button::left, true);
    EXPECT_TRUE(bench.session().pull());
    for (int k = 0; k < 4; ++k) {
      mouse(bench, WindowEvent::Kind::move, at.x() - 2, at.y() - 5.0F * float(k), render::Button::left, true);
      key(bench, render::Key::right);
    }
    mouse(bench, WindowEvent::Kind::release, at.x(), at.y() - 20, render::Button::left);
    for (int k = 0; k < 3; ++k) key(bench, render::Key::left);
    for (int k = 0; k < 3; ++k) key(bench, render::Key::right);
    bench.finish();
    EXPECT_EQ(bench.message(), "");
    return hexadecimal(sim::hash(bench.session().state()));
  }
  Options replayed(const std::string& out) const {
    Options again = options();
    again.replay = folder_ / "session.toml";
    again.out = folder_ / out;
    return again;
  }
};

TEST_F(Replay, EndsInTheSameState) {
  const std::string hash = act();
  ASSERT_EQ(record(replayed("one")), kDone);
  EXPECT_EQ(hash_in(folder_ / "one/run.json"), hash);
  EXPECT_EQ(read_session(folder_ / "session.toml").state_hash, hash);
  EXPECT_EQ(read_all(folder_ / "one/session.toml"), read_all(folder_ / "session.toml"));
}

TEST_F(Replay, DrawsTheSameFramesEveryTime) {
  act();
  Options panel = replayed("one"), again = replayed("two");
  panel.panel = again.panel = true;
  ASSERT_EQ(record(panel), kDone);
  ASSERT_EQ(record(again), kDone);
  int frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "one/frames")) {
    EXPECT_EQ(read_all(entry.path()), read_all(folder_ / "two/frames" / entry.path().filename())) << entry.path();
    ++frames;
  }
  EXPECT_EQ(frames, 6) << "0; steps 2, 4, 6, 8; and 8 again after the steps back";
}

TEST_F(Replay, OfASessionWithoutInputsIsTheRecording) {
  {
    Workbench bench(logged(), std::make_unique<Session>(logged()));
    for (int k = 0; k < 20; ++k) key(bench, render::Key::right);
    bench.finish();
  }
  ASSERT_EQ(record(replayed("one")), kDone);
  Options plain = options();
  plain.out = folder_ / "plain";
  ASSERT_EQ(record(plain), kDone);
  EXPECT_EQ(hash_in(folder_ / "one/run.json"), hash_in(folder_ / "plain/run.json"));
  for (int k = 0; k <= 10; ++k) {
    const std::string name = "frames/frame_000" + std::string(k < 10 ? "0" : "") + std::to_string(k) + ".png";
    EXPECT_EQ(read_all(folder_ / "one" / name), read_all(folder_ / "plain" / name)) << name;
  }
}

TEST_F(Replay, KeepsTheOptionsOfTheSession) {
  Options view = logged();
  view.overrides = {{"world.gravity", "[0, -2, 0]", "--set"}};
  std::string hash;
  {
    Workbench bench(view, std::make_unique<Session>(view));
    for (int k = 0; k < 3; ++k) key(bench, render::Key::right);
    bench.finish();
    hash = hexadecimal(sim::hash(bench.session().state()));
  }
  ASSERT_EQ(record(replayed("one")), kDone);
  EXPECT_EQ(hash_in(folder_ / "one/run.json"), hash);
}

TEST_F(Replay, ABrokenSessionIsRefusedWithItsLine) {
  struct Case {
    const char* text;
    const char* says;
  };
  const std::string head = "scene = \"beam.toml\"\n";
  for (const Case& c :
       {Case{"[[input]]\nstep = 3\ndo = \"jump\"\n", ":4: do = \"jump\": must be one of set, camera"},
        Case{"[[input]]\nstep = -1\ndo = \"reset\"\n", ":3: step = -1: must be an integer >= 0"},
        Case{"[[input]]\ndo = \"reset\"\n", ":2: 'step' is missing"},
        Case{"[[input]]\nstep = 1\ndo = \"set\"\nkey = \"time.fps\"\n", "'value' is missing"},
        Case{"[[input]]\nstep = 1\ndo = \"reset\"\nstpe = 2\n", ":5: unknown key 'stpe'"},
        Case{"[[input]]\nstep = 4\ndo = \"reset\"\n[[input]]\nstep = 3\ndo = \"back\"\n",
             ":6: step = 3: must not be before"},
        Case{"[[input]]\nstep = 1\ndo = \"pull-to\"\ntarget = [1, nan, 0]\n", ":5: target"},
        Case{"[[input]]\nstep = 1\ndo = \"pull-to\"\ntarget = 3\n", ":5: target = 3: must be"},
        Case{"input = 3\n", ":2: input = 3: must be a list"}, Case{"[[input]\n", ":2: "},
        Case{"[end]\nsteps = 4\n", "'state_hash' is missing"},
        Case{"[[input]]\nstep = 0\ndo = \"set\"\nkey = \"world.gravty\"\nvalue = 1\n", ":2: world.gravty"},
        Case{"[[input]]\nstep = 0\ndo = \"set\"\nkey = \"body.0.material.poisson\"\nvalue = 0.7\n",
             ":2: body.0.material.poisson=0.7: must be in (-1, 0.5)"}}) {
    write_all(folder_ / "session.toml", head + c.text);
    const std::string message = error_of([&] { record(replayed("bad")); });
    EXPECT_NE(message.find("session.toml"), std::string::npos) << message;
    EXPECT_NE(message.find(c.says), std::string::npos) << message << "\nwanted " << c.says;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "bad/frames/frame_00001.png"));
  }
}

}  // namespace
}  // namespace app
