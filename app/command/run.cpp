#include "app/base/output_file.h"
#include "app/command/commands.h"
#include "app/run/run_loop.h"
#include "app/run/run_start.h"

namespace app {
namespace {

// Draws nothing; only keeps the state to resume from.
class NoPictures : public FrameSink {
 public:
  NoPictures(const RunFolder& folder, int cores) : folder_(folder), cores_(cores) {}
  void add(Moment, std::string checkpoint) override {
    if (!checkpoint.empty()) write_atomically(folder_.state(), checkpoint, true);
  }
  void finish() override {}
  FrameSeconds seconds() const override { return {}; }
  DrawnBy drawn_by() const override { return {}; }
  int cores_for_steps() const override { return cores_; }

 private:
  const RunFolder& folder_;
  int cores_;
};

}  // namespace

int run(const Options& options) {
  const Simulation simulation = build_simulation(options);
  const RunFolder folder = open_run_folder(options);
  const RunStart start = make_start(simulation, folder, !options.resume.empty());
  NoPictures nothing(folder, options.threads);
  const Outcome outcome = run_loop(simulation, options, folder, start, nothing);
  return conclude(simulation, options, folder, outcome);
}

}  // namespace app
