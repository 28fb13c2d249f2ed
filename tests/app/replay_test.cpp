// The log that a session leaves, and its replay.
#include "app/base/exit_code.h"
#include "app/base/text.h"
#include "app/command/commands.h"
#include "app/run/state_file.h"
#include "app/session/session_file.h"
#include "render/png.h"
#include "tests/app/interrupt_when_there.h"
#include "tests/app/workbench_scene.h"

namespace app {
namespace {

using render::WindowEvent;

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
    bench.frame(frame_width, frame_height);
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
  ASSERT_EQ(record(replayed("one")), exit_done);
  EXPECT_EQ(hash_in(folder_ / "one/run.json"), hash);
  EXPECT_EQ(read_session(folder_ / "session.toml").state_hash, hash);
  EXPECT_EQ(read_all(folder_ / "one/session.toml"), read_all(folder_ / "session.toml"));
}

TEST_F(Replay, DrawsTheSameFramesEveryTime) {
  act();
  Options panel = replayed("one"), again = replayed("two");
  panel.panel = again.panel = true;
  ASSERT_EQ(record(panel), exit_done);
  ASSERT_EQ(record(again), exit_done);
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
  ASSERT_EQ(record(replayed("one")), exit_done);
  Options plain = options();
  plain.out = folder_ / "plain";
  ASSERT_EQ(record(plain), exit_done);
  EXPECT_EQ(hash_in(folder_ / "one/run.json"), hash_in(folder_ / "plain/run.json"));
  for (int k = 0; k <= 10; ++k) {
    const std::string name = "frames/frame_000" + std::string(k < 10 ? "0" : "") + std::to_string(k) + ".png";
    EXPECT_EQ(read_all(folder_ / "one" / name), read_all(folder_ / "plain" / name)) << name;
  }
}

// What run.json says behind a name, to the end of the line.
std::string said(const std::filesystem::path& run_json, const std::string& name) {
  const std::string text = read_all(run_json), key = "\"" + name + "\": ";
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return "not said";
  return text.substr(at + key.size(), text.find_first_of(",\n", at) - at - key.size());
}

TEST_F(Replay, CountsWhatARunCounts) {
  Options hard = logged();
  hard.overrides = {{"solver.max_iterations", "1", "--set"}};
  {
    Workbench bench(hard, std::make_unique<Session>(hard));
    for (int k = 0; k < 20; ++k) key(bench, render::Key::right);
    bench.finish();
  }
  ASSERT_EQ(record(replayed("one")), exit_done);
  Options plain = options();
  plain.overrides = hard.overrides;
  plain.out = folder_ / "plain";
  ASSERT_EQ(record(plain), exit_done);
  EXPECT_GT(std::stoi(said(folder_ / "one/run.json", "steps_not_converged")), 0);
  for (const char* const name : {"newton_iterations", "linear_iterations", "steps_not_converged", "steps_halved",
                                 "not_converged_reason", "min_J", "inverted_elements", "no_memory_for_factor"})
    EXPECT_EQ(said(folder_ / "one/run.json", name), said(folder_ / "plain/run.json", name)) << name;
}

// A session of so many steps without inputs, as if it had been left by a program of other scenes.
std::string steps_alone(int steps, const std::string& set) {
  return "scene = \"beam.toml\"\nset = [" + set + "]\n[end]\nsteps = " + std::to_string(steps) +
         "\nstate_hash = \"0123456789abcdef\"\n";
}

TEST_F(Replay, AnInterruptedOneIsWholeAndSaysHowFarItCame) {
  write_all(folder_ / "session.toml", steps_alone(1000000, ""));
  std::thread interrupter = interrupt_when_there(folder_ / "one/frames/frame_00003.png");
  testing::internal::CaptureStderr();
  const int code = record(replayed("one"));
  const std::string message = testing::internal::GetCapturedStderr();
  interrupter.join();
  EXPECT_EQ(code, exit_interrupted);
  const sim::State state = read_state_file(folder_ / "one/state.bin").state;
  EXPECT_EQ(message, "ritz: interrupted after step " + std::to_string(state.step) + " of 1000000\n");
  EXPECT_EQ(said(folder_ / "one/run.json", "status"), "\"interrupted\"");
  EXPECT_EQ(said(folder_ / "one/run.json", "steps"), std::to_string(state.step));
  Session session(options());
  take(session, static_cast<int>(state.step));
  EXPECT_EQ(hexadecimal(sim::hash(state)), hexadecimal(hash_of(session)));
  std::int64_t frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "one/frames")) {
    EXPECT_EQ(render::decode_png(read_all(entry.path())).width, 64) << entry.path();
    ++frames;
  }
  EXPECT_EQ(frames, state.step / 2 + 1);
}

TEST_F(Replay, OneThatFailsKeepsTheLastGoodState) {
  write_all(folder_ / "session.toml",
            steps_alone(1000, R"("time.integrator=symplectic-euler", "time.substeps=1", "body.0.material.young=1e6")"));
  testing::internal::CaptureStderr();
  const int code = record(replayed("one"));
  const std::string message = testing::internal::GetCapturedStderr();
  EXPECT_EQ(code, exit_numerical_failure);
  // A session with the same settings fails at the same step.
  Options unstable = options();
  for (const auto& [key, value] :
       {std::pair{"time.integrator", "symplectic-euler"}, {"time.substeps", "1"}, {"body.0.material.young", "1e6"}})
    unstable.overrides.push_back({key, value, key});
  Session session(unstable);
  sim::StepReport report;
  while (report.failure.empty() && session.steps() < 1000) report = session.step();
  ASSERT_NE(report.failure, "");
  const sim::State state = read_state_file(folder_ / "one/state.bin").state;
  EXPECT_GT(state.step, 0);
  EXPECT_EQ(hexadecimal(sim::hash(state)), hexadecimal(hash_of(session)));
  const std::filesystem::path json = folder_ / "one/run.json";
  EXPECT_EQ(said(json, "status"), "\"failed\"");
  EXPECT_NE(read_all(json).find("\"reason\": " + quoted_text(report.failure)), std::string::npos);
  EXPECT_EQ(said(json, "step"), std::to_string(state.step + 1)) << "of failed_at";
  EXPECT_EQ(message.find("ritz: " + failure_text(*session.simulation()->system, report) +
                         "\n      the last good state is saved in " + (folder_ / "one/state.bin").string() + "\n"),
            0U)
      << message;
  EXPECT_EQ(message.find("note: the session ended"), std::string::npos) << "it did not come that far";
}

// Where the replay does come to the end of the session, another state there is told.
TEST_F(Replay, SaysWhenItEndsElsewhere) {
  write_all(folder_ / "session.toml", steps_alone(4, ""));
  testing::internal::CaptureStderr();
  EXPECT_EQ(record(replayed("one")), exit_done);
  const std::string message = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(message.starts_with("note: the session ended in state 0123456789abcdef, the replay in " +
                                  hash_in(folder_ / "one/run.json") + ": "))
      << message;
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
  ASSERT_EQ(record(replayed("one")), exit_done);
  EXPECT_EQ(hash_in(folder_ / "one/run.json"), hash);
}

TEST_F(Replay, ABrokenSessionIsRefusedWithItsLine) {
  struct Case {
    const char* text;
    const char* says;
  };
  const std::string head = "scene = \"beam.toml\"\n";
  for (const Case& c :
       {Case{"[[input]]\nstep = 3\ndo = \"jump\"\n", ":4: do = \"jump\": must be one of \"set\", \"camera\""},
        Case{"[[input]]\nstep = -1\ndo = \"reset\"\n", ":3: step = -1: must be >= 0"},
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
