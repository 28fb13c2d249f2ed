// What stands behind the window: the session, how fast it plays, and what keys, mouse and panel do to it. Knows no
// window and no GL, so that it can be driven without either.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/options/options.h"
#include "app/panel/panel.h"
#include "app/picture/frame_history.h"
#include "app/record/frame_renderer.h"
#include "app/session/monitor.h"
#include "app/session/session.h"
#include "app/view/mouse.h"
#include "app/view/pace.h"
#include "app/view/ring_drag.h"
#include "app/view/session_record.h"
#include "render/frame.h"
#include "render/window.h"

namespace app {

class Workbench {
 public:
  // A session of what the options name, and their log, which it begins. Throws WriteError.
  Workbench(Options options, std::unique_ptr<Session> session);

  // Pixels at the left of a window of this size that the picture does not have.
  int panel_width(int width, int height) const { return panel_shown_ ? Panel::width(width, height) : 0; }
  // One thing that the user did, in a picture of this size. `over_widgets`: the mouse, or the typing, is the panel's.
  void handle(const render::WindowEvent& event, int width, int height, bool over_widgets);
  void act(Action action);
  // Takes the steps that `wall` seconds are worth, while it plays. True when there was one.
  bool advance(double wall);
  // What is to be seen in a picture of this size.
  const render::Frame& frame(int width, int height);
  // The widgets of a window of this size, in the frame of Dear ImGui that is under way; does what they ask for.
  void draw_panel(int width, int height);
  // Ends the log and the table of numbers beside it.
  void finish();

  bool playing() const { return playing_; }
  bool quits() const { return quits_; }
  const Session& session() const { return *session_; }
  const std::string& message() const { return message_; }
  void say(std::string message) { message_ = std::move(message); }
  // Where the screenshot that was asked for is to go, once.
  std::optional<std::filesystem::path> take_screenshot();

 private:
  void apply(const Input& input);
  bool step();
  void count_frame();
  void begin_record();
  Moment moment() const;
  bool reload();
  void turn_page(std::ptrdiff_t by);
  void save();
  void refresh_picture(int width, int height);
  // A name that is not taken: START-1END, START-2END, ...
  static std::filesystem::path free_name(const std::filesystem::path& start, const std::string& end);

  Options options_;
  std::filesystem::path first_log_;  // later ones are called after it
  std::unique_ptr<Session> session_;
  std::unique_ptr<SessionRecord> record_;  // where --log is given
  Monitor monitor_;
  Mouse mouse_;
  Pace pace_;
  Panel panel_;
  bool playing_ = false, quits_ = false, panel_shown_ = true, help_ = false, screenshot_ = false;
  RingDrag ring_drag_;
  std::optional<PullTo> pull_to_;  // applied before the next step: a mouse moves more often than that
  double time_ = 0;                // s simulated since the session began
  sim::StepReport report_;         // of the last step
  std::string message_;

  FrameHistory frames_;                      // the energies and colours of the frames so far
  LargestShown largest_{};                   // the largest value of each kind that they have shown in colour
  std::unique_ptr<const ShownScene> drawn_;  // makes frames of a simulation
  std::array<int, 2> size_{};                // pixels of the picture that drawn_ was made for
  std::shared_ptr<const Simulation> shown_;  // the simulation of now; where only the camera has moved since drawn_
  std::optional<render::Camera>
      camera_;  // was made, it keeps the older one, and this camera replaces that of its frames
  render::Frame frame_;
};

}  // namespace app
