#include "app/recorder.h"

#include <stdexcept>

#include "app/output_file.h"
#include "app/stopwatch.h"
#include "render/context.h"
#include "render/png.h"
#include "render/renderer.h"

namespace app {
namespace {

std::unique_ptr<Video> make_video(const Simulation& simulation, const Options& options) {
  if (options.video.empty()) return nullptr;
  const int fps = simulation.document.scene.time.fps;
  if (!options.resume.empty()) {
    throw std::runtime_error(
        "--video with --resume: a video cannot be gone on with. Resume without --video, then run\n  " +
        video_command(options.resume / "frames", options.video, fps, options.every));
  }
  const int every = options.still ? 1 : options.every;
  const VideoFormat format{options.width, options.height, fps, every};
  return std::make_unique<Video>(options.video, format, options.overwrite);
}

// The drawing thread owns its context and all that is in it; in the order of their making.
struct Easel {
  std::unique_ptr<render::Context> context = render::make_offscreen_context();
  render::Renderer renderer;

  Easel(int width, int height, int samples) : renderer(*context, width, height, samples) {}
};

}  // namespace

Recorder::Recorder(const Simulation& simulation, const RunFolder& folder, const Options& options)
    : simulation_(simulation),
      folder_(folder),
      width_(options.width),
      height_(options.height),
      samples_(options.samples),
      every_(options.every),
      still_(options.still),
      picture_(*simulation.system, simulation.document, double(options.width) / options.height),
      expectation_(options.expect.empty() ? std::nullopt : std::optional<Expectation>(std::in_place, options, folder)),
      video_(make_video(simulation, options)),
      stages_([this] { return make_draw(); }, [this](const Drawn& drawn) { write(drawn); }) {
  if (!video_) folder_.make_folder(folder_.frames());
}

bool Recorder::is_drawn(std::int64_t frame) const {
  return still_ ? frame == simulation_.last_frame() : frame % every_ == 0;
}

void Recorder::add(Moment moment, std::string checkpoint) {
  const bool draw = is_drawn(moment.frame);
  if (!draw && checkpoint.empty()) return;
  if (draw) ++frames_drawn_;
  const Stopwatch watch;
  stages_.push({std::move(moment), draw, std::move(checkpoint)});
  waiting_ += watch.seconds();
}

void Recorder::finish() {
  const Stopwatch watch;
  stages_.finish();
  if (video_) video_->finish();
  if (expectation_) expectation_->write_table();
  waiting_ += watch.seconds();
}

FrameSeconds Recorder::seconds() const {
  return {stages_.drawing_seconds(), stages_.writing_seconds(), waiting_};
}

Recorder::Stages::Draw Recorder::make_draw() const {
  return [this, easel = std::make_shared<Easel>(width_, height_, samples_)](Job job) {
    Drawn drawn{job.moment.frame, std::nullopt, std::move(job.checkpoint)};
    if (job.draw) drawn.image = easel->renderer.draw(picture_.frame(job.moment));
    return drawn;
  };
}

void Recorder::write(const Drawn& drawn) {
  if (drawn.image && video_) {
    video_->write(*drawn.image);
  } else if (drawn.image) {
    write_atomically(folder_.frame(drawn.frame), as_text(render::encode_png(*drawn.image)), false);
  }
  if (drawn.image && expectation_) expectation_->compare(drawn.frame, *drawn.image);
  if (!drawn.checkpoint.empty()) write_atomically(folder_.state(), drawn.checkpoint, true);
}

}  // namespace app
