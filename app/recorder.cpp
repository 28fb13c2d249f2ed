#include "app/recorder.h"

#include <stdexcept>

#include "app/output_file.h"
#include "app/stopwatch.h"
#include "render/context.h"
#include "render/gui.h"
#include "render/png.h"
#include "render/renderer.h"

namespace app {
namespace {

// Two pictures of the same height, side by side.
render::Image beside(const render::Image& left, const render::Image& right) {
  render::Image both{left.width + right.width, left.height, {}};
  both.rgba.reserve(left.rgba.size() + right.rgba.size());
  for (int y = 0; y < left.height; ++y) {
    for (const render::Image* image : {&left, &right}) {
      const auto row = image->rgba.begin() + std::ptrdiff_t{4} * image->width * y;
      both.rgba.insert(both.rgba.end(), row, row + std::ptrdiff_t{4} * image->width);
    }
  }
  return both;
}

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

}  // namespace

// The drawing thread owns its context and all that is in it; in the order of their making.
struct Recorder::Easel {
  Easel(int width_, int height_, int panel_width_, int samples)
      : width(width_),
        height(height_),
        panel_width(panel_width_),
        renderer(*context, width - panel_width, height, samples) {
    if (panel_width > 0) gui.emplace(*context, Panel::text_size(width, height));
  }
  render::Image draw(const Job& job);

  int width, height, panel_width;  // of the frame; the panel stands at its left
  std::unique_ptr<render::Context> context = render::make_offscreen_context();
  render::Renderer renderer;
  std::optional<render::Gui> gui;
  Panel panel;
};

render::Image Recorder::Easel::draw(const Job& job) {
  const Sight& sight = *job.sight;
  render::Image picture = renderer.draw(sight.picture.frame(job.moment));
  if (!gui) return picture;
  const std::int64_t step = job.moment.state.step;
  const sim::System& system = *sight.simulation->system;
  PanelState state{sight.simulation->document, system, sight.waiting, job.samples, system.time(step), step};
  state.clock = false;
  return beside(gui->picture(panel_width, height, [&] { panel.draw(state, panel_width, height); }), picture);
}

Recorder::Recorder(std::shared_ptr<const Simulation> simulation, const RunFolder& folder, const Options& options)
    : folder_(folder),
      width_(options.width),
      height_(options.height),
      samples_(options.samples),
      every_(options.every),
      last_frame_(simulation->last_frame()),
      still_(options.still),
      panel_width_(options.panel ? Panel::width(options.width, options.height) : 0),
      expectation_(options.expect.empty() ? std::nullopt : std::optional<Expectation>(std::in_place, options, folder)),
      video_(make_video(*simulation, options)),
      sight_(make_sight(std::move(simulation), {})),
      stages_([this] { return make_draw(); }, [this](const Drawn& drawn) { write(drawn); }) {
  if (!video_) folder_.make_folder(folder_.frames());
}

std::shared_ptr<const Recorder::Sight> Recorder::make_sight(std::shared_ptr<const Simulation> simulation,
                                                            std::vector<Override> waiting) const {
  Picture picture(*simulation->system, simulation->document, double(width_ - panel_width_) / height_);
  return std::make_shared<const Sight>(Sight{std::move(simulation), std::move(picture), std::move(waiting)});
}

void Recorder::show(std::shared_ptr<const Simulation> simulation, std::vector<Override> waiting) {
  sight_ = make_sight(std::move(simulation), std::move(waiting));
}

bool Recorder::is_drawn(std::int64_t frame) const {
  return still_ ? frame == last_frame_ : frame % every_ == 0;
}

void Recorder::add(Moment moment, std::string checkpoint) {
  if (panel_width_ > 0 && moment.frame > 0) {
    const Simulation& now = *sight_->simulation;
    const double t = static_cast<double>(moment.frame) / now.document.scene.time.fps;
    monitor_.add(sample_of(t, *now.system, moment.state, moment.report));
  }
  const bool draw = is_drawn(moment.frame);
  if (!draw && checkpoint.empty()) return;
  if (draw) ++frames_drawn_;
  const Stopwatch watch;
  stages_.push(
      {std::move(moment), draw, std::move(checkpoint), sight_, draw ? monitor_.samples() : std::vector<Sample>()});
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
  return [this, easel = std::make_shared<Easel>(width_, height_, panel_width_, samples_)](Job job) {
    Drawn drawn{job.moment.frame, std::nullopt, job.checkpoint};
    if (job.draw) drawn.image = easel->draw(job);
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
