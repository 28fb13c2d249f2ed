#include "app/record/frame_renderer.h"

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

}  // namespace

FrameSize::FrameSize(const Options& options)
    : width(options.width),
      height(options.height),
      panel(options.panel ? Panel::width(options.width, options.height) : 0),
      samples(options.samples) {}

FrameRenderer::FrameRenderer(const FrameSize& size, const std::string& context)
    : size_(size),
      context_(render::make_offscreen_context(context)),
      renderer_(*context_, size.width - size.panel, size.height, size.samples) {
  if (size.panel > 0) gui_.emplace(*context_, Panel::text_size(size.width, size.height));
}

render::Image FrameRenderer::draw(const ShownScene& shown, const Moment& moment, const std::vector<Sample>& samples) {
  render::Image picture = renderer_.draw(shown.picture.frame(moment));
  if (!gui_) return picture;
  const std::int64_t step = moment.state.step;
  const sim::System& system = *shown.simulation->system;
  PanelState state{shown.simulation->document, system, shown.waiting, samples, system.time(step), step};
  state.clock = false;
  return beside(gui_->picture(size_.panel, size_.height, [&] { panel_.draw(state, size_.panel, size_.height); }),
                picture);
}

}  // namespace app
