#include "app/trade/notebook.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/base/output_file.h"
#include "app/base/text.h"
#include "app/scene/scene_error.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_identity.h"
#include "app/trade/case_file.h"

namespace app {
namespace {

constexpr double look_share = 0.02;     // of the time: a first look
constexpr double repeat_share = 0.004;  // of the time: shorter runs are timed three times

}  // namespace

Notebook::Notebook(const Comparison& comparison, std::filesystem::path folder, double seconds, std::ostream* out,
                   const Interrupt& interrupt)
    : comparison_(comparison), folder_(std::move(folder)), seconds_(seconds), out_(out), interrupt_(interrupt) {
  make_folder(folder_);
}

std::filesystem::path Notebook::file(std::uint64_t id) const {
  return folder_ / (hexadecimal(id) + ".run");
}

void Notebook::keep(const CaseRun& run) const {
  if (run.status != CaseStatus::skipped && run.id != 0) write_atomically(file(run.id), encode(run), false);
}

void Notebook::say(const std::string& line) const {
  if (!out_) return;
  *out_ << formatted("[%3.0f of %.0f s] ", watch_.seconds(), seconds_) << line << std::endl;
}

CaseRun* Notebook::known(std::uint64_t id) {
  const auto found = std::ranges::find_if(runs_, [&](const CaseRun& run) { return run.id == id && id != 0; });
  if (found != runs_.end()) return &*found;
  std::ifstream in(file(id), std::ios::binary);
  if (!in) return nullptr;
  auto read = decode_case(std::string{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
  if (!read || read->id != id) return nullptr;
  runs_.push_back(std::move(*read));
  return &runs_.back();
}

const CaseRun& Notebook::add(CaseRun run) {
  runs_.push_back(std::move(run));
  if (changed_) changed_();
  return runs_.back();
}

void Notebook::skip(const TradeCase& which, const std::string& reason) {
  CaseRun run;
  run.which = which;
  run.reason = reason;
  add(told(std::move(run)));
}

const CaseRun& Notebook::run(const TradeCase& which, double allowance) {
  const Options options = options_of(comparison_.options, which);
  try {
    const std::uint64_t id = case_id(
        comparison_, scene_identity(load_scene(options.scene, options.settings, options.overrides)), options.threads);
    if (CaseRun* const earlier = known(id)) return *earlier;
    if (!recall_only_.empty() || left() <= 0) {
      CaseRun run;
      run.which = which;
      run.id = id;
      run.reason = recall_only_.empty() ? "no time left" : recall_only_;
      return add(std::move(run));
    }
    const Allowance allowed{std::min(allowance, left()), repeat_share * seconds_};
    CaseRun run = run_case(comparison_, which, build_simulation(options, &comparison_.scene), allowed, interrupt_);
    keep(run);
    return add(told(std::move(run)));
  } catch (const SceneError& error) {
    return add(told(refused_case(which, error.what())));
  }
}

// Says how it went.
CaseRun Notebook::told(CaseRun run) const {
  say(run.which.label + (run.status == CaseStatus::done ? formatted(": %.3g s per simulated second", run.work.median())
                         : run.status == CaseStatus::failed ? ": failed, " + run.reason
                                                            : ": skipped, " + run.reason));
  return run;
}

double Notebook::first_look(const TradeCase& which) {
  const Simulation simulation = build_simulation(options_of(comparison_.options, which), &comparison_.scene);
  const CaseRun run = run_case(comparison_, which, simulation, {0, 0, look_share * seconds_}, interrupt_);
  return run.status == CaseStatus::skipped ? run.estimate : run.work.median() * comparison_.seconds();
}

CaseRun Notebook::run_afresh(const TradeCase& which) {
  const Simulation simulation = build_simulation(options_of(comparison_.options, which), &comparison_.scene);
  return run_case(comparison_, which, simulation, {1e12, repeat_share * seconds_}, interrupt_);
}

std::vector<sim::TimedStep> Notebook::time_steps(const CaseRun& run, double seconds) {
  const Simulation simulation = build_simulation(options_of(comparison_.options, run.which), &comparison_.scene);
  return timed_steps(comparison_, run.which, simulation, seconds, interrupt_);
}

}  // namespace app
