#include "app/record/replay.h"

#include <iostream>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/output_file.h"
#include "app/base/progress.h"
#include "app/base/stopwatch.h"
#include "app/base/text.h"
#include "app/mesh/contents.h"
#include "app/picture/frame_history.h"
#include "app/record/recorder.h"
#include "app/run/numbers_log.h"
#include "app/run/run_json.h"
#include "app/run/run_start.h"
#include "app/scene/scene_identity.h"
#include "app/session/session.h"
#include "app/session/session_file.h"

namespace app {
namespace {

// The scene as it was when the session began: what the options say now comes last.
Options options_of(const SessionFile& file, Options options) {
  if (options.settings.empty()) options.settings = file.settings;
  options.overrides.insert(options.overrides.begin(), file.overrides.begin(), file.overrides.end());
  return options;
}

class Replayer {
 public:
  Replayer(const SessionFile& file, const Options& options, Session& session, const RunFolder& folder,
           Recorder& recorder, Outcome& outcome)
      : file_(file),
        session_(session),
        recorder_(recorder),
        outcome_(outcome),
        shown_(session.simulation()),
        history_(*shown_),
        numbers_(folder.numbers()),
        progress_(std::cerr, progress_style(options.quiet), {0, file.steps, shown_->system->step_seconds()},
                  Progress::Clock::now()) {}

  void go() {
    outcome_.status = Status::done;
    apply_inputs();
    add_frame({});
    while (outcome_.status == Status::done && session_.steps() < file_.steps) {
      if (interrupt_.requested()) {
        outcome_.status = Status::interrupted;
      } else {
        step();
      }
    }
    recorder_.finish();
    numbers_.close();
    outcome_.run.state = session_.state();
    progress_.finish(session_.steps(), Progress::Clock::now());
  }

 private:
  void step() {
    const sim::StepReport report = session_.step();
    if (!outcome_.add(report)) {
      outcome_.status = Status::failed;
      return;
    }
    const bool frame = session_.state().step % session_.simulation()->system->steps_per_frame() == 0;
    apply_inputs();
    if (frame) add_frame(report);
    progress_.update(session_.steps(), Progress::Clock::now());
  }

  // What was done before the next step.
  void apply_inputs() {
    for (; next_ < file_.inputs.size() && file_.inputs[next_].event.step == session_.steps(); ++next_) {
      try {
        session_.apply(file_.inputs[next_].event.input);
      } catch (const std::runtime_error& error) {
        throw SceneError(file_.inputs[next_].place + ": " + error.what());
      }
      history_.revise(*session_.simulation(), session_.state(), outcome_.run.totals.largest);
    }
  }

  void add_frame(const sim::StepReport& report) {
    if (shown_ != session_.simulation()) {
      shown_ = session_.simulation();
      history_.follow(*shown_);
      recorder_.show(shown_, session_.waiting());
    }
    history_.add(session_.state(), outcome_.run.totals.largest);
    Moment moment{.frame = frames_++,
                  .newton = report.newton,
                  .state = session_.state(),
                  .min_J = report.min_J,
                  .report = report};
    history_.fill(outcome_.run.totals.largest, moment);
    numbers_.add(moment);
    recorder_.add(std::move(moment), {});
  }

  const SessionFile& file_;
  Session& session_;
  Recorder& recorder_;
  Outcome& outcome_;
  std::shared_ptr<const Simulation> shown_;
  FrameHistory history_;
  NumbersLog numbers_;
  std::size_t next_ = 0;
  std::int64_t frames_ = 0;
  Progress progress_;
  Interrupt interrupt_;
};

void compare(const SessionFile& file, const Outcome& outcome) {
  if (file.state_hash.empty() || outcome.status != Status::done) return;
  const std::string hash = hexadecimal(sim::hash(outcome.run.state));
  if (hash == file.state_hash) return;
  std::cerr << "note: the session ended in state " << file.state_hash << ", the replay in " << hash
            << ": scene, mesh or program are not the same as then\n";
}

}  // namespace

int replay(const Options& options) {
  const Stopwatch watch;
  const SessionFile file = read_session(options.replay);
  const Options used = options_of(file, options);
  Session session(used);
  const double building = watch.seconds();
  const RunFolder folder = open_run_folder(used);
  make_folder(folder.path());
  folder.clear();
  Outcome outcome;
  Recorder recorder(session.simulation(), folder, used);
  Replayer(file, used, session, folder, recorder, outcome).go();
  // The last simulation stands for the session, whose scene changed.
  Simulation last = *session.simulation();
  last.build_seconds = building;
  outcome.run.scene = scene_identity(last.document);
  outcome.total = watch.seconds();
  write_atomically(folder.session(), read_contents(options.replay), false);
  write_state_file(folder.state(), outcome.run);
  write_atomically(folder.run_json(), run_json(last, used, folder, outcome, recorder), true);
  compare(file, outcome);
  if (outcome.status == Status::interrupted) {
    std::cerr << "ritz: interrupted after step " << session.steps() << " of " << file.steps << '\n';
    return exit_interrupted;
  }
  return judged(conclude(last, used, folder, outcome), recorder, folder, used);
}

}  // namespace app
