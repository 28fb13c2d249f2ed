#include "app/record/recorder.h"

#include <array>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "app/base/exit_code.h"
#include "app/base/output_file.h"
#include "app/base/process.h"
#include "app/base/stopwatch.h"
#include "render/png.h"

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

// Frames that are gone on with keep their size. A PNG has its width and height at bytes 16 and 20, high byte first (PNG
// specification, 11.2.1).
FrameSize frame_size(const Options& options, const RunFolder& folder) {
  const FrameSize size(options);
  if (options.resume.empty()) return size;
  std::array<char, 24> head{};
  std::ifstream file(folder.frame(0), std::ios::binary);
  if (!file.read(head.data(), head.size())) return size;
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(head[i]);
    return value;
  };
  if (number(16) == size.width && number(20) == size.height) return size;
  const std::string stored = std::to_string(number(16)) + "x" + std::to_string(number(20));
  throw std::runtime_error("--resume " + folder.path().string() + ": its frames are " + stored +
                           ", new ones would be " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                           "; add --size " + stored);
}

std::string context_name(const Options& options) {
  return options.context.empty() ? std::string(render::offscreen_kinds().front().name) : options.context;
}

}  // namespace

Recorder::Recorder(std::shared_ptr<const Simulation> simulation, const RunFolder& folder, const Options& options)
    : folder_(folder),
      size_(frame_size(options, folder)),
      every_(options.every),
      last_frame_(simulation->last_frame()),
      still_(options.still),
      expectation_(options.expect.empty() ? std::nullopt : std::optional<Expectation>(std::in_place, options, folder)),
      video_(make_video(*simulation, options)),
      shown_(make_shown(std::move(simulation), {})),
      drawn_by_{context_name(options), ""},
      cores_(share_cores(*shown_->simulation, options)),
      stages_([this] { return make_draw(); }, [this](const Drawn& drawn) { write(drawn); }) {
  if (!video_) make_folder(folder_.frames());
}

std::shared_ptr<const ShownScene> Recorder::make_shown(std::shared_ptr<const Simulation> simulation,
                                                       std::vector<Override> waiting) const {
  Picture picture(*simulation->system, simulation->document, size_.picture(), size_.height);
  return std::make_shared<const ShownScene>(ShownScene{std::move(simulation), std::move(picture), std::move(waiting)});
}

void Recorder::show(std::shared_ptr<const Simulation> simulation, std::vector<Override> waiting) {
  shown_ = make_shown(std::move(simulation), std::move(waiting));
}

bool Recorder::is_drawn(std::int64_t frame) const {
  return still_ ? frame == last_frame_ : frame % every_ == 0;
}

void Recorder::add(Moment moment, std::string checkpoint) {
  if (size_.panel > 0 && moment.frame > 0) {
    const Simulation& now = *shown_->simulation;
    const double t = static_cast<double>(moment.frame) / now.document.scene.time.fps;
    monitor_.add(sample_of(t, *now.system, moment.state, moment.report));
  }
  const bool draw = is_drawn(moment.frame);
  if (!draw && checkpoint.empty()) return;
  if (draw) ++frames_drawn_;
  const Stopwatch watch;
  stages_.push(
      {std::move(moment), draw, std::move(checkpoint), shown_, draw ? monitor_.samples() : std::vector<Sample>()});
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

Recorder::Stages::Draw Recorder::make_draw() {
  give_to_rasteriser(cores_.drawing);
  const auto renderer = std::make_shared<FrameRenderer>(size_, drawn_by_.context);
  drawn_by_.driver = renderer->driver();
  return [this, renderer](Job job) {
    Drawn drawn{job.moment.frame, std::nullopt, std::move(job.checkpoint)};
    if (job.draw) drawn.image = renderer->draw(*job.shown, job.moment, job.samples);
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

std::string Recorder::video_command_to(const std::filesystem::path& file) const {
  return video_command(folder_.frames(), file, shown_->simulation->document.scene.time.fps, every_);
}

int judged(int code, const Recorder& recorder, const RunFolder& folder, const Options& options) {
  if (!options.quiet) {
    const std::filesystem::path place = options.video.empty() ? folder.frames() : options.video;
    std::cerr << recorder.frames_drawn() << " frames in " << place.string() << '\n';
    if (options.video.empty() && recorder.frames_drawn() > 1 && is_installed("ffmpeg")) {
      const std::filesystem::path video = folder.path() / options.scene.filename().replace_extension(".mp4");
      std::cerr << "a video of them: " << recorder.video_command_to(video) << '\n';
    }
  }
  const std::optional<Expectation>& expectation = recorder.expectation();
  if (code != exit_done || !expectation) return code;
  if (!options.quiet || !expectation->fulfilled()) std::cerr << expectation->summary() << '\n';
  return expectation->fulfilled() ? exit_done : exit_frames_differ;
}

}  // namespace app
