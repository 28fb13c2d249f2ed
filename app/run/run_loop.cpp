#include "app/run/run_loop.h"

#include <iostream>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/base/interrupt.h"
#include "app/base/output_file.h"
#include "app/base/progress.h"
#include "app/base/stopwatch.h"
#include "app/base/text.h"
#include "app/picture/frame_history.h"
#include "app/run/contact_totals.h"
#include "app/run/curves_log.h"
#include "app/run/numbers_log.h"
#include "app/run/read_energies.h"
#include "app/run/run_json.h"
#include "app/run/run_log.h"
#include "app/run/vtu.h"
#include "app/scene/scene_text.h"
#include "sim/stepper.h"
#include "sim/study/overlap.h"

namespace app {
namespace {

// What a resumed run goes on after: how many of so many steps it has taken.
std::optional<std::int64_t> resumed_step(const RunStart& start, int steps) {
  return start.resumed ? std::optional(start.run.state.step / steps) : std::nullopt;
}

class Runner {
 public:
  Runner(const Simulation& simulation, const Options& options, const RunFolder& folder, const RunStart& start,
         FrameSink& sink, Outcome& outcome)
      : system_(*simulation.system),
        fps_(simulation.document.scene.time.fps),
        last_frame_(simulation.last_frame()),
        vtu_every_(options.vtu ? options.every : 0),
        folder_(folder),
        sink_(sink),
        outcome_(outcome),
        stepper_(sim::make_stepper(system_, sim::useful_threads(system_, sink.cores_for_steps()),
                                   [this] { return interrupt_.requested(); })),
        log_(system_, simulation.document.scene.probes, folder, resumed_step(start, 1)),
        history_(simulation, start.resumed ? read_energies(folder.steps(), system_, start.run.state.step)
                                           : std::vector<Energies>()),
        numbers_(folder.numbers(), resumed_step(start, system_.steps_per_frame())),
        curves_(folder, system_, history_.traces(), resumed_step(start, 1)),
        overlap_(system_),
        progress_(std::cerr, progress_style(options.quiet),
                  {start.run.state.step, simulation.last_step(), system_.step_seconds()}, Progress::Clock::now()) {
    if (vtu_every_ > 0) make_folder(folder_.vtu_folder());
  }

  // The initial state, of a run that was not resumed.
  void begin() {
    log_.start(state());
    frame_reached({});
  }

  void go(std::int64_t last_step) {
    while (state().step < last_step) {
      if (interrupt_.requested()) return end(Status::interrupted);
      if (!step()) return end(interrupt_.requested() ? Status::interrupted : Status::failed);
    }
    end(Status::done);
  }

 private:
  const sim::State& state() const { return outcome_.run.state; }

  // False when the step could not be taken; the state is then the last good one.
  bool step() {
    const sim::StepReport report = stepper_->step(outcome_.run.state);
    if (report.interrupted || !outcome_.add(report)) return false;
    progress_.note(note(report, outcome_.run.totals, log_.step(state(), report)));
    progress_.update(state().step, Progress::Clock::now());
    if (state().step % system_.steps_per_frame() == 0) frame_reached(report);
    return true;
  }

  // ", Newton 3 (increment 2e-05), 34 contacts, least gap 0.00021 m, 3 steps not converged, 12 halved": of the last
  // step, then of all.
  static std::string note(const sim::StepReport& report, const Totals& totals,
                          const std::vector<sim::ContactReport>& contacts) {
    std::string text;
    if (report.newton > 0) text = formatted(", Newton %d (increment %.1g)", report.newton, report.increment);
    if (!contacts.empty()) text += ", " + contact_text(totals_of(contacts));
    if (totals.not_converged > 0) text += ", " + std::to_string(totals.not_converged) + " steps not converged";
    if (totals.splits > 0) text += ", " + std::to_string(totals.splits) + " halved";
    return text;
  }

  void frame_reached(const sim::StepReport& report) {
    const std::int64_t frame = state().step / system_.steps_per_frame();
    if (vtu_every_ > 0 && frame % vtu_every_ == 0) {
      write_atomically(folder_.vtu(frame), vtu_text(system_, state()), false);
    }
    look_for_overlap();
    history_.add(state(), outcome_.run.totals.largest);
    Moment moment{.frame = frame, .newton = report.newton, .state = state(), .min_J = report.min_J, .report = report};
    history_.fill(outcome_.run.totals.largest, moment);
    numbers_.add(moment);
    curves_.add(frame);
    std::string checkpoint;
    if (frame > 0 && frame < last_frame_ && frame % fps_ == 0) {  // once a simulated second
      log_.sync();
      numbers_.sync();
      curves_.sync();
      checkpoint = encode(outcome_.run);
    }
    sink_.add(std::move(moment), std::move(checkpoint));
  }

  // Said once, of the first two.
  void look_for_overlap() {
    if (!outcome_.overlap.empty()) return;
    if (const auto pair = overlap_.find(state()))
      outcome_.overlap = formatted("\"%s\" and \"%s\" go through each other from t = %.3g s on", pair->first.c_str(),
                                   pair->second.c_str(), system_.time(state().step));
  }

  // Everything is on the disk before state.bin says that the run has come this far.
  void end(Status status) {
    sink_.finish();
    log_.sync();
    log_.close();
    numbers_.sync();
    numbers_.close();
    curves_.sync();
    curves_.close();
    write_state_file(folder_.state(), outcome_.run);
    if (vtu_every_ > 0) write_pvd();
    progress_.finish(state().step, Progress::Clock::now());
    outcome_.status = status;
  }

  void write_pvd() const {
    std::vector<std::pair<double, std::string>> files;
    const int steps_per_frame = system_.steps_per_frame();
    for (std::int64_t frame = 0; frame * steps_per_frame <= state().step; frame += vtu_every_) {
      files.emplace_back(system_.time(frame * steps_per_frame), "vtu/" + RunFolder::vtu_name(frame));
    }
    write_atomically(folder_.pvd(), pvd_text(files), false);
  }

  const sim::System& system_;
  int fps_;
  std::int64_t last_frame_;
  int vtu_every_;  // 0: no VTU files
  const RunFolder& folder_;
  FrameSink& sink_;
  Outcome& outcome_;
  std::unique_ptr<sim::Stepper> stepper_;
  RunLog log_;
  FrameHistory history_;
  NumbersLog numbers_;
  CurvesLog curves_;
  sim::Overlap overlap_;
  Progress progress_;
  Interrupt interrupt_;
};

}  // namespace

Outcome run_loop(const Simulation& simulation, const Options& options, const RunFolder& folder, const RunStart& start,
                 FrameSink& sink) {
  const Stopwatch watch;
  make_folder(folder.path());
  if (!start.resumed) folder.clear();
  if (!options.quiet) {
    for (const std::string& remark : simulation.remarks()) std::cerr << "note: " << remark << '\n';
  }
  Outcome outcome;
  outcome.run = start.run;
  if (start.resumed) outcome.resumed_step = start.run.state.step;
  const auto write_json = [&] {
    outcome.total = simulation.build_seconds + watch.seconds();
    write_atomically(folder.run_json(), run_json(simulation, options, folder, outcome, sink), true);
  };
  write_json();
  write_atomically(folder.scene(), scene_toml(simulation.document, folder.path()), false);
  try {
    Runner runner(simulation, options, folder, start, sink, outcome);
    if (!start.resumed) runner.begin();
    runner.go(simulation.last_step());
  } catch (const std::exception& error) {
    outcome.status = Status::failed;
    outcome.error = error.what();
    try {
      write_json();
    } catch (const WriteError&) {  // the disk that was full for a frame may be full for this as well
    }
    throw;
  }
  write_json();
  return outcome;
}

}  // namespace app
