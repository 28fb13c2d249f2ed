// Draws the frames of a run and writes them as PNG files or a video, while the run goes on.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/options/options.h"
#include "app/record/cores.h"
#include "app/record/expectation.h"
#include "app/record/frame_renderer.h"
#include "app/record/pipeline.h"
#include "app/record/video.h"
#include "app/run/frame_sink.h"
#include "app/run/run_folder.h"
#include "app/scene/simulation.h"
#include "render/image.h"

namespace app {

class Recorder : public FrameSink {
 public:
  // Makes ready to draw and starts ffmpeg where a video is wanted; throws std::runtime_error when either cannot be
  // done. `folder` must outlive it.
  Recorder(std::shared_ptr<const Simulation> simulation, const RunFolder& folder, const Options& options);

  void add(Moment moment, std::string checkpoint) override;
  void finish() override;
  FrameSeconds seconds() const override;
  DrawnBy drawn_by() const override { return drawn_by_; }
  int cores_for_steps() const override { return cores_.stepping; }
  // From the next frame on: the scene as it has become, with values that wait for a restart.
  void show(std::shared_ptr<const Simulation> simulation, std::vector<Override> waiting);
  int frames_drawn() const { return frames_drawn_; }
  // What to type to make a video of the frames that were written, in `file`.
  std::string video_command_to(const std::filesystem::path& file) const;
  // How the frames compare with those of --expect; none without it. To be asked after finish().
  const std::optional<Expectation>& expectation() const { return expectation_; }

 private:
  struct Job {
    Moment moment;
    bool draw = true;
    std::string checkpoint;
    std::shared_ptr<const ShownScene> shown;  // shared: the drawing thread may be some frames behind
    std::vector<Sample> samples;
  };
  struct Drawn {
    std::int64_t frame = 0;
    std::optional<render::Image> image;
    std::string checkpoint;
  };
  using Stages = Pipeline<Job, Drawn>;

  bool is_drawn(std::int64_t frame) const;
  std::shared_ptr<const ShownScene> make_shown(std::shared_ptr<const Simulation> simulation,
                                               std::vector<Override> waiting) const;
  Stages::Draw make_draw();
  void write(const Drawn& drawn);

  const RunFolder& folder_;
  FrameSize size_;
  int every_;
  std::int64_t last_frame_;
  bool still_;
  int frames_drawn_ = 0;
  double waiting_ = 0;
  Monitor monitor_;  // frame by frame, for the panel's plots
  std::optional<Expectation> expectation_;
  std::unique_ptr<Video> video_;
  std::shared_ptr<const ShownScene> shown_;
  DrawnBy drawn_by_;
  Cores cores_;
  Stages stages_;  // last: its threads use all of the above
};

// Says what was drawn, and how it compares with --expect; the exit code, which was `code` so far.
int judged(int code, const Recorder& recorder, const RunFolder& folder, const Options& options);

}  // namespace app
