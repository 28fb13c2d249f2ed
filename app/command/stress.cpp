// `ritz stress`: bodies at the extremes, and whether they find back.
#include <atomic>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/output_file.h"
#include "app/base/progress.h"
#include "app/base/stopwatch.h"
#include "app/command/commands.h"
#include "app/scene/scene_file.h"
#include "app/scene/simulation.h"
#include "app/stress/flight.h"
#include "app/stress/table.h"
#include "sim/mesh/input_error.h"

namespace app {
namespace {

constexpr std::int64_t long_run = 100000;  // steps

// From where it is, with the scene's longer steps, until it is at rest.
sim::Recovery go_on(const sim::Scene& scene, const sim::State& from, const std::function<bool()>& interrupted) {
  constexpr std::int64_t most_steps = 1000;
  const sim::System system(scene, 1);
  sim::State state = system.initial_state();
  state.x = from.x;
  state.v = from.v;
  return sim::recover(system, state, most_steps, {}, interrupted);
}

CaseResult run_case(const StabilityCase& c, const std::function<bool()>& interrupted) {
  const Stopwatch watch;
  CaseResult result;
  try {
    sim::Scene scene = c.scene();
    const sim::System system(scene, 1);
    for (const std::string& remark : system.remarks())
      if (remark.starts_with("locking")) result.locking = remark;
    sim::State state = system.initial_state();
    result.recovery = sim::recover(system, state, c.steps, {c.extreme->loaded, c.extreme->keeps_energy()}, interrupted);
    if (result.recovery.verdict == sim::Verdict::moving && c.extreme->is_patient() && slow_down(scene))
      result.recovery.then(go_on(scene, state, interrupted));
  } catch (const sim::InputError& error) {
    result.refused = error.what();
  }
  result.seconds = watch.seconds();
  return result;
}

// Runs the cases on some threads and prints them in their order, each as soon as those before it are done.
class Board {
 public:
  Board(const std::vector<StabilityCase>& cases, bool quiet)
      : cases_(cases), style_(progress_style(quiet)), results_(cases.size()), done_(cases.size()) {}

  // The results of the cases that were run: all of them, unless interrupted.
  std::vector<CaseResult> run(int threads) {
    std::cout << table_header() << '\n';
    std::vector<std::thread> workers;
    for (int k = 0; k < threads; ++k) workers.emplace_back([this] { work(); });
    for (std::thread& worker : workers) worker.join();
    results_.resize(printed_);
    return std::move(results_);
  }
  bool interrupted() const { return interrupt_.requested(); }

 private:
  void work() {
    const auto stop = [this] { return interrupted(); };
    for (std::size_t k = next_++; k < cases_.size() && !interrupted(); k = next_++) {
      CaseResult result = run_case(cases_[k], stop);
      if (interrupted()) return;
      const std::lock_guard lock(mutex_);
      results_[k] = std::move(result);
      done_[k] = true;
      ++finished_;
      print();
    }
  }

  void print() {
    const bool bar = style_ == ProgressStyle::bar;
    if (bar) std::cerr << "\r\x1b[K";
    for (; printed_ < cases_.size() && done_[printed_]; ++printed_)
      std::cout << table_row(cases_[printed_], results_[printed_]) << '\n';
    std::cout << std::flush;
    if (!bar || finished_ == cases_.size()) return;
    const double left = watch_.seconds() / double(finished_) * double(cases_.size() - finished_);
    std::cerr << progress_bar(double(finished_) / double(cases_.size())) << "case " << finished_ << '/' << cases_.size()
              << ", " << clock_text(left) << " left" << std::flush;
  }

  const std::vector<StabilityCase>& cases_;
  ProgressStyle style_;
  std::vector<CaseResult> results_;
  std::vector<bool> done_;
  std::size_t printed_ = 0, finished_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  Stopwatch watch_;
  Interrupt interrupt_;
};

std::vector<Subject> subjects(const Options& options) {
  if (options.scene.empty()) return built_in_subjects(options.quick);
  const Document document = load_scene(options.scene, options.settings, options.overrides);
  require_bodies(document);
  return {subject_of(document.scene)};
}

std::filesystem::path csv_path(const Options& options) {
  const std::filesystem::path folder = options.out.empty() ? std::filesystem::path("out/stress") : options.out;
  std::filesystem::path file = folder / "stress.csv";
  if (!options.overwrite && std::filesystem::exists(file))
    throw std::runtime_error(file.string() + ": exists already; choose another folder with -o, or --overwrite");
  make_folder(folder);
  return file;
}

}  // namespace

int stress(const Options& options) {
  const std::vector<Subject> bodies = subjects(options);
  const std::vector<Extreme> rows = extremes();
  std::vector<StabilityCase> cases =
      make_cases(bodies, rows, {options.quick, options.only, options.seed, options.seeds});
  if (cases.empty()) throw std::runtime_error("--only " + options.only + ": no case has this in its name");
  const std::filesystem::path file = csv_path(options);
  Board board(cases, options.quiet);
  const std::vector<CaseResult> results = board.run(options.threads);
  cases.resize(results.size());
  std::cout << table_summary(cases, results);
  if (options.scene.empty() && options.only.empty() && !options.quick && !board.interrupted())
    std::cout << flight_table(fly(long_run, options.threads, [&] { return board.interrupted(); }), long_run);
  write_atomically(file, stability_csv(cases, results), false);
  return board.interrupted() ? exit_interrupted : exit_done;
}

}  // namespace app
