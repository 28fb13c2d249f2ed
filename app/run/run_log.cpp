#include "app/run/run_log.h"

namespace app {
namespace {

// `step`: the step that a run goes on after; none: a new table. A table has a row for each step, and `first` before.
Csv open_table(const std::filesystem::path& path, const std::string& header, std::optional<std::int64_t> step,
               int first) {
  return step ? Csv(path, header, *step + first) : Csv(path, header);
}

}  // namespace

RunLog::RunLog(const sim::System& system, const std::vector<sim::Probe>& probes, const RunFolder& folder,
               std::optional<std::int64_t> resumed_step)
    : system_(system),
      probe_count_(static_cast<int>(probes.size())),
      probes_(open_table(folder.probes(), probes_header(probes, system.dimension()), resumed_step, 1)),
      steps_(open_table(folder.steps(), steps_header(system.contact_pairs() > 0), resumed_step, 0)) {
  const int pairs = system.contact_pairs();
  if (pairs == 0) return;
  if (resumed_step)
    contacts_.emplace(folder.contacts(), contacts_header(), *resumed_step * pairs);
  else
    contacts_.emplace(folder.contacts(), contacts_header());
}

void RunLog::start(const sim::State& state) {
  probes_.row(probes_row(system_, state, probe_count_));
}

std::vector<sim::ContactReport> RunLog::step(const sim::State& state, const sim::StepReport& report) {
  probes_.row(probes_row(system_, state, probe_count_));
  std::vector<sim::ContactReport> contacts = system_.contacts(state);
  steps_.row(steps_row(system_, state, report, contacts));
  if (contacts_) contacts_->row(contacts_rows(system_.time(state.step), contacts));
  return contacts;
}

void RunLog::sync() {
  probes_.sync();
  steps_.sync();
  if (contacts_) contacts_->sync();
}

void RunLog::close() {
  probes_.close();
  steps_.close();
  if (contacts_) contacts_->close();
}

}  // namespace app
