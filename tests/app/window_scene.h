// `ritz view` in a real window, on a display of its own (Xvfb), driven by real key and mouse events (xdotool).
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/base/process.h"
#include "render/png.h"
#include "tests/app/session_scene.h"

namespace app {

using namespace std::chrono_literals;

// A program that runs until it is waited for.
class Process {
 public:
  Process(std::vector<std::string> arguments, const std::string& output, const std::string& display) {
    pid_ = fork();
    if (pid_ != 0) return;
    const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (display.empty()) {
      unsetenv("DISPLAY");
    } else {
      setenv("DISPLAY", display.c_str(), 1);
    }
    unsetenv("WAYLAND_DISPLAY");
    std::vector<char*> list;
    for (std::string& argument : arguments) list.push_back(argument.data());
    list.push_back(nullptr);
    execvp(list[0], list.data());
    _exit(127);
  }
  ~Process() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // Its exit code; -1 when it did not end by itself in time.
  int wait(std::chrono::milliseconds most) {
    for (auto waited = 0ms; waited <= most; waited += 20ms) {
      int status = 0;
      if (waitpid(pid_, &status, WNOHANG) == pid_) {
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      }
      std::this_thread::sleep_for(20ms);
    }
    return -1;
  }
  void signal(int number) const { kill(pid_, number); }
  bool runs() { return waitpid(pid_, nullptr, WNOHANG) == 0; }
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
};

inline const std::string ritz_program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "ritz";

class WindowTest : public SessionScene {
 protected:
  void SetUp() override {
    if (!is_installed("Xvfb") || !is_installed("xdotool"))
      GTEST_SKIP() << "Xvfb and xdotool are not installed: tests/run does";
    // Xvfb takes a display that is free and writes its number.
    display_ = std::make_unique<Process>(
        std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp"},
        log("xvfb"), "");
    ASSERT_TRUE(eventually([&] {
      std::istringstream text(read_all(log("xvfb")));
      for (std::string line; std::getline(text, line) && !text.eof();) {
        if (!line.empty() && line.find_first_not_of("0123456789") == std::string::npos) name_ = ":" + line;
      }
      return !name_.empty();
    })) << read_all(log("xvfb"));
  }

  static bool eventually(const std::function<bool()>& holds, std::chrono::milliseconds most = 10s) {
    for (auto waited = 0ms; waited < most; waited += 20ms) {
      if (holds()) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }
  std::string log(const std::string& name) const { return (folder_ / (name + ".log")).string(); }

  std::unique_ptr<Process> view(std::vector<std::string> more = {}) {
    return view_of(folder_ / "beam.toml", "600x400", std::move(more));
  }
  // A scene or a deck, whose first screenshot is called after the stem of a scene file.
  std::unique_ptr<Process> view_of(const std::filesystem::path& scene, const std::string& size,
                                   std::vector<std::string> more = {}, const std::string& stem = "beam") {
    std::vector<std::string> arguments = {ritz_program,
                                          "view",
                                          scene.string(),
                                          "--size",
                                          size,
                                          "--log",
                                          (folder_ / "session.toml").string(),
                                          "-o",
                                          folder_.path().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    auto ritz = std::make_unique<Process>(arguments, log("ritz"), name_);
    stem_ = stem;
    // Keys go to the window under the mouse; the first screenshot tells that it is drawn.
    EXPECT_TRUE(eventually([&] {
      tool("mousemove 450 200 key ctrl+p");
      std::this_thread::sleep_for(200ms);
      return std::filesystem::exists(shot(1));
    })) << read_all(log("ritz"));
    // Others that were asked for meanwhile come too.
    for (int before = -1; before != shots_;) {
      before = shots_;
      std::this_thread::sleep_for(700ms);
      while (std::filesystem::exists(shot(shots_ + 1))) ++shots_;
    }
    return ritz;
  }
  void tool(const std::string& words) const {
    std::vector<std::string> arguments = {"xdotool"};
    std::istringstream text(words);
    for (std::string word; text >> word;) arguments.push_back(word);
    EXPECT_EQ(Process(arguments, log("xdotool"), name_).wait(5s), 0) << words << ": " << read_all(log("xdotool"));
    std::this_thread::sleep_for(150ms);  // some frames, on a machine with other work too
  }
  // What the log says was done, in order.
  std::vector<std::string> done() const {
    std::istringstream text(read_all(folder_ / "session.toml"));
    std::vector<std::string> words;
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("do = ")) words.push_back(line.substr(6, line.size() - 7));
    }
    return words;
  }
  std::filesystem::path shot(int number) const { return folder_ / (stem_ + "-" + std::to_string(number) + ".png"); }
  // What the window shows, after all that was done before.
  render::Image screenshot() {
    tool("key ctrl+p");
    const std::filesystem::path file = shot(++shots_);
    EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file); })) << file;
    return render::decode_png(read_all(file));
  }

  // Records what was done, into the folder "replay".
  void replayed(const std::vector<std::string>& more) const {
    replay_of(folder_ / "beam.toml", folder_ / "session.toml", folder_ / "replay", more);
  }
  void replay_of(const std::filesystem::path& scene, const std::filesystem::path& session,
                 const std::filesystem::path& out, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {ritz_program,     "record", scene.string(), "--replay",
                                          session.string(), "-o",     out.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    ASSERT_EQ(Process(arguments, log("replay"), "").wait(60s), 0) << read_all(log("replay"));
  }
  std::string name_;
  std::string stem_;
  int shots_ = 0;  // screenshots that there are
  std::unique_ptr<Process> display_;
};

}  // namespace app
