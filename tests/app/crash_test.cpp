// A run that is killed, or has no room left, leaves what a later run can go on from.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <thread>

#include "app/base/exit_code.h"
#include "app/base/output_file.h"
#include "app/command/commands.h"
#include "app/run/state_file.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

constexpr const char* crash_scene = R"(
[time]
seconds = 120
fps = 1
[world]
gravity = [0, 0, 0]
[[body]]
mesh = { box = [1, 1, 1], cells = [3, 3, 3], element = "tet4" }
start = { shape = "scrambled" }
spin = { rate = 1 }
)";

class Crash : public testing::Test {
 protected:
  Crash() { write_all(folder_ / "scene.toml", crash_scene); }

  Options options(const std::string& out) const {
    Options options;
    options.scene = folder_ / "scene.toml";
    options.out = folder_ / out;
    options.quiet = true;
    return options;
  }
  Options resumed(const std::string& out) const {
    Options resumed = options(out);
    resumed.resume = resumed.out;
    resumed.out.clear();
    return resumed;
  }

  // Calls f in a process of its own; its exit code, or minus the signal that ended it.
  template <class F>
  static int in_child(
      const F& f, const std::function<void(pid_t)>& meanwhile = [](pid_t) {}) {
    const pid_t child = fork();
    if (child == 0) {
      try {
        _exit(f());
      } catch (...) {
        _exit(77);
      }
    }
    meanwhile(child);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  TemporaryFolder folder_;
};

// The state file is rewritten after every simulated second, here after every step: whenever the process is killed, the
// file is a whole one, and the run goes on to the same end.
TEST_F(Crash, KilledAtAnyMomentItGoesOnToTheSameEnd) {
  ASSERT_EQ(in_child([&] { return run(options("straight")); }), exit_done);
  const std::string end = read_all(folder_ / "straight/state.bin");
  std::mt19937 random(5);
  int killed = 0;
  for (int k = 0; k < 8; ++k) {
    const std::string out = "killed" + std::to_string(k);
    const auto state = folder_ / out / "state.bin";
    const int delay = std::uniform_int_distribution(0, 40000)(random);
    killed += in_child([&] { return run(options(out)); },
                       [&](pid_t child) {
                         while (!std::filesystem::exists(state))
                           std::this_thread::sleep_for(std::chrono::microseconds(200));
                         std::this_thread::sleep_for(std::chrono::microseconds(delay));
                         kill(child, SIGKILL);
                       }) == -SIGKILL;
    EXPECT_NO_THROW(read_state_file(state)) << delay;
    ASSERT_EQ(in_child([&] { return run(resumed(out)); }), exit_done) << delay;
    EXPECT_EQ(read_all(state), end) << delay;
  }
  EXPECT_GT(killed, 4);
}

// No room for more than so many bytes a file: an error that names the file; what was saved before stays whole.
TEST_F(Crash, WithoutRoomTheLastStateStays) {
  Options first = options("out");
  first.overrides.push_back({"time.seconds", "5", "--seconds 5"});
  ASSERT_EQ(in_child([&] { return run(first); }), exit_done);
  const std::string before = read_all(folder_ / "out/state.bin");
  const int code = in_child([&] {
    const rlimit limit{before.size() - 1, before.size() - 1};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      return run(resumed("out"));
    } catch (const WriteError& error) {
      return std::string(error.what()).find("File too large") == std::string::npos ? 1 : 55;
    }
  });
  EXPECT_EQ(code, 55);
  EXPECT_EQ(read_all(folder_ / "out/state.bin"), before);
  EXPECT_EQ(in_child([&] { return run(resumed("out")); }), exit_done);
}

TEST_F(Crash, AFolderThatCannotBeMadeOrWrittenIsNamed) {
  write_all(folder_ / "file", "");
  const std::string message = error_of([&] { run(options("file/out")); });
  EXPECT_NE(message.find("cannot make the folder"), std::string::npos) << message;
  EXPECT_NE(message.find("file/out"), std::string::npos) << message;
  std::filesystem::create_directory(folder_ / "locked");
  chmod(folder_.path().c_str(), 0755);
  chmod((folder_ / "locked").c_str(), 0555);
  const auto locked_out = [&] {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && setuid(nobody) != 0) return 1;  // root may write anywhere
    return error_of([&] { run(options("locked/out")); }).find("locked") == std::string::npos ? 1 : 55;
  };
  EXPECT_EQ(in_child(locked_out), 55);
}

}  // namespace
}  // namespace app
