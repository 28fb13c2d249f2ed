// A run whose scene changes while it goes on: what `ritz view` shows and a replay repeats. No window, no clock: the
// same inputs between the same steps give the same bits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/exhibit/exhibit.h"
#include "app/scene/scene_file.h"
#include "app/scene/simulation.h"
#include "app/session/history.h"
#include "app/session/input.h"
#include "sim/stepper.h"

namespace app {

class Session {
 public:
  // Reads the scene that the options name (scene, settings, overrides, threads). Throws SceneError.
  explicit Session(const Options& options);

  // Throws SceneError where the input is refused: nothing has changed then.
  void apply(const Input& input);
  // One step. On failure (report.failure not empty) the state stays the last good one.
  sim::StepReport step();

  std::int64_t steps() const { return steps_; }  // taken so far; steps back and resets do not count
  const sim::State& state() const { return state_; }
  // As it is now; a change makes a new one, and leaves this to those who still hold it.
  std::shared_ptr<const Simulation> simulation() const { return simulation_; }
  // The scene with all values that were set, without the pull of the mouse: what is saved.
  const Document& document() const { return document_; }
  // Keys whose new values wait for the restart, in the order in which they were set.
  const std::vector<Override>& waiting() const { return waiting_; }
  // The spring of the mouse, while it pulls.
  const std::optional<sim::Spring>& pull() const { return pull_; }
  std::size_t history() const { return history_.size(); }
  // Those that the last change of a key was tried with, so that pictures need not make them again.
  Exhibits take_exhibits() { return std::exchange(exhibits_, {}); }

 private:
  void handle(const SetKey& input);
  void handle(const MoveCamera& input);
  void handle(const Pull& input);
  void handle(const PullTo& input);
  void handle(const Release&);
  void handle(const StepBack&);
  void handle(const Reset&);
  void handle(const Restart&);

  Document read(const std::vector<Override>& overrides) const;
  // The simulation of the document, with the pull.
  std::shared_ptr<const Simulation> build(const Document& document, const std::optional<sim::Spring>& pull) const;
  void show(const Document& document);
  void go_on_with(std::shared_ptr<const Simulation> next);
  void switch_if_due();
  void begin(std::shared_ptr<const Simulation> first);

  std::filesystem::path scene_, cache_;
  int threads_;
  Layer items_;                      // what the files said when the session began
  std::vector<Override> overrides_;  // and what was set since
  std::vector<Override> waiting_;
  std::optional<sim::Spring> pull_;

  Document document_;
  Exhibits exhibits_;
  std::shared_ptr<const Simulation> simulation_, next_;  // next_: waits for a time that its steps reach exactly
  std::unique_ptr<sim::Stepper> stepper_;                // of simulation_
  sim::State state_;
  History history_;
  std::int64_t steps_ = 0;
};

}  // namespace app
