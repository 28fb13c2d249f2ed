#include "app/view/workbench.h"

#include <algorithm>
#include <utility>

#include "app/base/output_file.h"
#include "app/base/stopwatch.h"
#include "app/picture/stage.h"
#include "app/scene/scene_text.h"
#include "app/view/camera_moves.h"
#include "app/view/shortcut.h"

namespace app {
namespace {

constexpr double stepping = 0.03;  // s of wall time between two pictures

}  // namespace

Workbench::Workbench(Options options, std::unique_ptr<Session> session)
    : options_(std::move(options)),
      first_log_(options_.log),
      session_(std::move(session)),
      frames_(*session_->simulation()) {
  count_frame();
  if (!options_.out.empty()) make_folder(options_.out);
  if (options_.log.empty()) return;
  SessionRecord::check(options_);
  begin_record();
}

void Workbench::begin_record() {
  record_ = std::make_unique<SessionRecord>(options_, session_->document().scene.dimension);
}

void Workbench::handle(const render::WindowEvent& event, int width, int height, bool over_widgets) {
  if (event.kind == render::WindowEvent::Kind::key) {
    const bool command = event.control || event.key == render::Key::f1;
    if (over_widgets && !command) return;
    if (const std::optional<Action> action = action_of(event)) act(*action);
    return;
  }
  const bool begins = event.kind == render::WindowEvent::Kind::press || event.kind == render::WindowEvent::Kind::scroll;
  if (begins && over_widgets) return;
  const RingDrag::Answer drag = ring_drag_.handle(event, frames_, session_->state(), width, height);
  if (drag.change) apply(*drag.change);
  if (drag.taken) return;
  frame(width, height);
  const std::optional<Input> input =
      mouse_.handle(event, {frame_, *session_->simulation()->system, session_->state(), width, height});
  if (!input) return;
  if (const auto* pull = std::get_if<PullTo>(&*input)) {
    pull_to_ = *pull;
    return;
  }
  apply(*input);
}

void Workbench::act(Action action) {
  const bool wireframe = session_->document().look.wireframe;
  switch (action) {
    case Action::play:
      playing_ = !playing_;
      return pace_.restart();
    case Action::step:
      playing_ = false;
      step();
      return;
    case Action::back:
      playing_ = false;
      return apply(StepBack{});
    case Action::reset:
      mouse_.drop();
      return apply(Reset{});
    case Action::restart:
      mouse_.drop();
      return apply(Restart{});
    case Action::reload:
      reload();
      return;
    case Action::page_back:
      return turn_page(-1);
    case Action::page_on:
      return turn_page(1);
    case Action::save:
      return save();
    case Action::screenshot:
      screenshot_ = true;
      return;
    case Action::help:
      help_ = !help_;
      return;
    case Action::hide_panel:
      panel_shown_ = !panel_shown_;
      return;
    case Action::wireframe:
      return apply(SetKey{"look.wireframe", wireframe ? "false" : "true"});
    case Action::quit:
      quits_ = true;
      return;
  }
}

bool Workbench::advance(double wall) {
  if (!playing_) return false;
  const double h = session_->simulation()->system->step_seconds();
  pace_.pass(wall, h);
  const Stopwatch watch;
  bool stepped = false;
  while (playing_ && pace_.due(h) && watch.seconds() < stepping) {
    stepped = true;
    if (!step()) break;
    pace_.stepped(h);
  }
  return stepped;
}

// False, and no longer playing, when the step cannot be taken.
bool Workbench::step() {
  if (pull_to_) apply(*std::exchange(pull_to_, std::nullopt));
  if (record_) record_->write_frame([this] { return moment(); });
  const std::shared_ptr<const Simulation> simulation = session_->simulation();
  const sim::StepReport report = session_->step();
  if (!report.failure.empty()) {
    playing_ = false;
    message_ =
        "A step cannot be taken: " + failure_text(*simulation->system, report) + ". The state is the last good one.";
    return false;
  }
  message_.clear();
  report_ = report;
  time_ += simulation->system->step_seconds();
  monitor_.add(sample_of(time_, *session_->simulation()->system, session_->state(), report));
  count_frame();
  return true;
}

// What a frame shows of those before it is told at the frames' own times, as in a recording.
void Workbench::count_frame() {
  const Simulation& simulation = *session_->simulation();
  frames_.follow(simulation);
  if (session_->state().step % simulation.system->steps_per_frame() != 0) return;
  frames_.add(session_->state(), largest_);
  if (record_) record_->reach_frame();
}

void Workbench::apply(const Input& input) {
  const Event event{session_->steps(), input};
  if (!std::holds_alternative<PullTo>(input)) pull_to_.reset();
  try {
    session_->apply(input);
  } catch (const std::runtime_error& refused) {
    message_ = refused.what();
    return;
  }
  message_.clear();
  frames_.revise(*session_->simulation(), session_->state(), largest_, session_->take_exhibits());
  if (record_) record_->write(event);
  const auto* move = std::get_if<MoveCamera>(&input);
  if (move == nullptr) return;
  // The picture itself stays as it is.
  camera_ = frame_.camera = moved(frame_.camera, *move);
  shown_ = session_->simulation();
}

// The page before or after this one, if there is one.
void Workbench::turn_page(std::ptrdiff_t by) {
  const auto now = std::ranges::find(options_.deck, options_.scene);
  if (now == options_.deck.end()) return;
  const std::ptrdiff_t page = now - options_.deck.begin() + by;
  if (page < 0 || page >= std::ssize(options_.deck)) return;
  const std::filesystem::path before = options_.scene;
  options_.scene = options_.deck[static_cast<std::size_t>(page)];
  if (!reload()) options_.scene = before;
}

// A new session, with a new log. False, and nothing has changed, when the file cannot be used.
bool Workbench::reload() {
  std::unique_ptr<Session> session;
  try {
    session = std::make_unique<Session>(options_);
  } catch (const std::runtime_error& error) {
    message_ = error.what();
    return false;
  }
  message_ = "Read again: " + options_.scene.string();
  finish();  // what was written stays
  session_ = std::move(session);
  monitor_.clear();
  mouse_.drop();
  pull_to_.reset();
  time_ = 0;
  largest_ = {};
  frames_ = FrameHistory(*session_->simulation());
  count_frame();
  if (options_.log.empty()) return true;
  // The file as it is now begins a session of its own.
  options_.log = free_name(first_log_.parent_path() / first_log_.stem(), first_log_.extension().string());
  begin_record();
  message_ += "; the log goes on in " + options_.log.string();
  return true;
}

void Workbench::save() {
  const std::filesystem::path file = free_name(options_.out / options_.scene.stem(), ".toml");
  try {
    write_atomically(file, scene_toml(session_->document(), options_.out), true);
    message_ = "Saved: " + file.string();
  } catch (const WriteError& error) {
    message_ = error.what();
  }
}

std::filesystem::path Workbench::free_name(const std::filesystem::path& start, const std::string& end) {
  for (int k = 1;; ++k) {
    std::filesystem::path name = start.string() + "-" + std::to_string(k) + end;
    if (!std::filesystem::exists(name)) return name;
  }
}

std::optional<std::filesystem::path> Workbench::take_screenshot() {
  if (!std::exchange(screenshot_, false)) return std::nullopt;
  std::filesystem::path file = free_name(options_.out / options_.scene.stem(), ".png");
  message_ = "Screenshot: " + file.string();
  return file;
}

void Workbench::refresh_picture(int width, int height) {
  const std::shared_ptr<const Simulation> simulation = session_->simulation();
  const std::array<int, 2> size{width, height};
  if (drawn_ && shown_ == simulation && size == size_) return;
  Picture picture(*simulation->system, simulation->document, width, height);
  drawn_ = std::make_unique<const ShownScene>(ShownScene{simulation, std::move(picture), {}});
  shown_ = simulation;
  size_ = size;
  camera_.reset();
}

Moment Workbench::moment() const {
  const sim::State& state = session_->state();
  Moment moment{.frame = state.step / session_->simulation()->system->steps_per_frame(),
                .newton = report_.newton,
                .state = state,
                .min_J = report_.min_J,
                .report = report_};
  frames_.fill(largest_, moment);
  return moment;
}

const render::Frame& Workbench::frame(int width, int height) {
  refresh_picture(width, height);
  frame_ = drawn_->picture.frame(moment());
  if (camera_) frame_.camera = *camera_;
  const auto& grip = mouse_.grip();
  if (grip && session_->pull()) {
    const sim::Vec3 target = pull_to_ ? pull_to_->target : session_->pull()->target;
    const sim::Vec3 now =
        place_of(*session_->simulation()->system, session_->state(), grip->picked.body, grip->picked.node);
    const sim::Vec3& origin = drawn_->picture.origin();
    frame_.arrows.push_back({to_point(now - origin), to_point(target - origin)});
  }
  return frame_;
}

void Workbench::draw_panel(int width, int height) {
  if (help_) draw_help(width, height);
  if (!panel_shown_) return;
  const std::shared_ptr<const Simulation> simulation = session_->simulation();
  const std::int64_t step = session_->state().step;
  const PanelState state{session_->document(),
                         *simulation->system,
                         session_->waiting(),
                         monitor_.samples(),
                         simulation->system->time(step),
                         step,
                         playing_,
                         pace_.factor(),
                         message_};
  const PanelRequests requests = panel_.draw(state, panel_width(width, height), height);
  for (const SetKey& change : requests.changes) apply(change);
  for (const Action action : requests.actions) act(action);
}

void Workbench::finish() {
  if (!record_) return;
  record_->write_frame([this] { return moment(); });
  record_->end(session_->steps(), session_->state());
  record_.reset();
}

}  // namespace app
