#include "app/session/session.h"

#include <algorithm>
#include <utility>

#include "app/scene/value_text.h"
#include "app/session/pull.h"
#include "sim/stepper.h"

namespace app {
namespace {

// A key that is set again loses its old value; the new one comes last, so that it wins over what it excludes.
std::vector<Override> with(std::vector<Override> overrides, Override added) {
  std::erase_if(overrides, [&](const Override& old) { return old.key == added.key; });
  overrides.push_back(std::move(added));
  return overrides;
}

Override override_of(std::string key, std::string value) {
  std::string origin = key + "=" + value;
  return {std::move(key), std::move(value), std::move(origin)};
}

const Key& key_at(const std::string& path) {
  Indices indices{};
  const Key* key = find_key_at(path, indices);
  if (key == nullptr || key->kind == Kind::table || key->kind == Kind::list) {
    throw SceneError(path + ": there is no such key with a value");
  }
  return *key;
}

// The same simulation, seen differently.
std::shared_ptr<const Simulation> seen_as(const Simulation& simulation, const Document& document) {
  auto seen = std::make_shared<Simulation>(simulation);
  seen->document.title = document.title;
  seen->document.camera = document.camera;
  seen->document.look = document.look;
  seen->document.exhibits = document.exhibits;
  seen->document.scene.time.seconds = document.scene.time.seconds;
  return seen;
}

// The step of `to` that is at the time of step n of `from`; none when its steps miss that time. Frames are the same.
std::optional<std::int64_t> same_time(std::int64_t n, const sim::System& from, const sim::System& to) {
  const std::int64_t scaled = n * to.steps_per_frame();
  if (scaled % from.steps_per_frame() != 0) return std::nullopt;
  return scaled / from.steps_per_frame();
}

// What a solver keeps from step to step belongs to the system that it was made for.
void forget_solver(sim::State& state) {
  state.force.resize(0);
  state.kept = {};
  if (state.coordinates.c.size() > 0) state.fastest.resize(0);  // it has as many numbers
  state.coordinates = {};
}

}  // namespace

Session::Session(const Options& options)
    : scene_(options.scene),
      cache_(options.cache),
      threads_(options.threads),
      items_(read_scene(options.scene, options.settings)),
      overrides_(options.overrides),
      document_(read(overrides_)) {
  begin(build(document_, pull_));
}

void Session::apply(const Input& input) {
  std::visit([this](const auto& kind) { handle(kind); }, input);
}

sim::StepReport Session::step() {
  history_.push(state_);
  sim::StepReport report = stepper_->step(state_);
  if (!report.failure.empty()) {
    history_.pop();
    return report;
  }
  ++steps_;
  switch_if_due();
  return report;
}

void Session::handle(const SetKey& input) {
  const Override added = override_of(input.key, input.value);
  const Effect effect = *key_at(input.key).effect;
  if (effect == Effect::restart) {
    std::vector<Override> waiting = with(waiting_, added), all = overrides_;
    for (const Override& each : waiting) all = with(std::move(all), each);
    read(all);  // refused now rather than at the restart
    waiting_ = std::move(waiting);
    return;
  }
  std::vector<Override> overrides = with(overrides_, added);
  Document document = read(overrides);
  if (effect == Effect::look) {
    exhibits_ = make_exhibits(document, simulation_->system);  // refused now rather than in a picture
    show(document);
  } else {
    std::shared_ptr<const Simulation> next = build(document, pull_);
    exhibits_ = make_exhibits(document, next->system);
    go_on_with(std::move(next));
  }
  document_ = std::move(document);
  overrides_ = std::move(overrides);
}

void Session::handle(const MoveCamera& input) {
  const auto take = [&](const std::string& path, const Value& value) {
    const Key& key = *find_key(path);
    key.binding.set(document_, {}, value);
    overrides_ = with(std::move(overrides_), override_of(path, value_text(key, value, document_.scene.dimension)));
  };
  const auto numbers = [](const sim::Vec3& v) { return std::vector<double>{v.begin(), v.end()}; };
  // A camera that is moved by hand follows no script any more.
  if (document_.camera.orbit != 0) take("camera.orbit", 0.0);
  if (!document_.camera.follow.empty()) take("camera.follow", std::string());
  if (!document_.camera.keyframes.empty()) {
    document_.camera.keyframes.clear();
    overrides_ = with(std::move(overrides_), override_of("camera.keyframes", "[]"));
  }
  if (input.eye && document_.scene.dimension == 3) take("camera.eye", numbers(*input.eye));
  if (input.target) take("camera.target", numbers(*input.target));
  if (input.height && document_.scene.dimension == 2) take("camera.height", *input.height);
  show(document_);
}

void Session::handle(const Pull& input) {
  const sim::Spring spring = spring_of_pull(document_.scene, input);
  go_on_with(build(document_, spring));
  pull_ = spring;
}

void Session::handle(const PullTo& input) {
  if (!pull_ || pull_->target == input.target) return;
  sim::Spring spring = *pull_;
  spring.target = input.target;
  go_on_with(build(document_, spring));
  pull_ = spring;
}

void Session::handle(const Release&) {
  if (!pull_) return;
  go_on_with(build(document_, std::nullopt));
  pull_.reset();
}

void Session::handle(const StepBack&) {
  if (auto before = history_.pop()) state_ = std::move(*before);
}

void Session::handle(const Reset&) {
  handle(Release{});
  begin(next_ ? next_ : simulation_);
}

void Session::handle(const Restart&) {
  std::vector<Override> overrides = overrides_;
  for (const Override& each : waiting_) overrides = with(std::move(overrides), each);
  Document document = read(overrides);
  std::shared_ptr<const Simulation> first = build(document, std::nullopt);
  document_ = std::move(document);
  overrides_ = std::move(overrides);
  waiting_.clear();
  pull_.reset();
  begin(std::move(first));
}

Document Session::read(const std::vector<Override>& overrides) const {
  return load_scene(items_, scene_, overrides);
}

std::shared_ptr<const Simulation> Session::build(const Document& document,
                                                 const std::optional<sim::Spring>& pull) const {
  auto simulation = std::make_shared<Simulation>();
  simulation->document = document;
  make_bases(*simulation, simulation_.get(), cache_, threads_);
  if (pull) simulation->document.scene.springs.push_back(*pull);
  simulation->system = build_system(simulation->document, threads_);
  return simulation;
}

// The looks of the document for what is shown, and for what will be.
void Session::show(const Document& document) {
  simulation_ = seen_as(*simulation_, document);
  if (next_) next_ = seen_as(*next_, document);
}

void Session::go_on_with(std::shared_ptr<const Simulation> next) {
  next_ = std::move(next);
  switch_if_due();
}

// The bodies go on from where they are, in the new system: at the same time, to the bit.
void Session::switch_if_due() {
  if (!next_) return;
  const std::optional<std::int64_t> step = same_time(state_.step, *simulation_->system, *next_->system);
  if (!step) return;
  if (next_->system->step_seconds() != simulation_->system->step_seconds()) {
    state_.x_before.resize(0);  // one step before is another time now
    state_.v_before.resize(0);
    history_.clear();
  }
  state_.step = *step;
  forget_solver(state_);
  history_.for_each(forget_solver);
  simulation_ = std::exchange(next_, nullptr);
  stepper_ = sim::make_stepper(*simulation_->system, sim::useful_threads(*simulation_->system, threads_));
}

void Session::begin(std::shared_ptr<const Simulation> first) {
  simulation_ = std::move(first);
  next_.reset();
  stepper_ = sim::make_stepper(*simulation_->system, sim::useful_threads(*simulation_->system, threads_));
  state_ = simulation_->system->initial_state();
  history_.clear();
}

}  // namespace app
