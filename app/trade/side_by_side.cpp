#include "app/trade/side_by_side.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "app/base/output_file.h"
#include "app/base/text.h"
#include "app/picture/picture.h"
#include "app/record/video.h"
#include "app/trade/run_case.h"
#include "render/context.h"
#include "render/png.h"
#include "render/renderer.h"

namespace app {
namespace {

constexpr double least_reach = 1;  // pixels: what is less is not seen, and looks like nothing

// Pictures of one size, row by row.
render::Image tiled(const std::vector<std::vector<render::Image>>& rows) {
  const render::Image& one = rows.front().front();
  const int columns = static_cast<int>(rows.front().size());
  render::Image all{columns * one.width, static_cast<int>(rows.size()) * one.height, {}};
  for (const std::vector<render::Image>& row : rows)
    for (int y = 0; y < one.height; ++y)
      for (const render::Image& image : row) {
        const auto line = image.rgba.begin() + std::ptrdiff_t{4} * image.width * y;
        all.rgba.insert(all.rgba.end(), line, line + std::ptrdiff_t{4} * image.width);
      }
  return all;
}

// The name of a run must not be too long for its picture.
std::string fitting(const std::string& text) {
  constexpr std::size_t most = 64;
  return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

// Draws one column: a run, and below it how far it is from the first.
class Column {
 public:
  Column(const Comparison& comparison, const Shown& shown, const CaseRun& reference, int width, int height)
      : system_(*comparison.scene.system),
        shown_(shown),
        document_(document_of(comparison, shown)),
        apart_(pixels_apart(comparison, *shown.run, reference)),
        picture_(system_, document_, width, height) {
    for (const sim::BodyRange& body : system_.bodies()) {
      const Skin* const skin = document_.meshes[surfaces_.size()].skin.get();
      surfaces_.push_back(skin != nullptr ? Surface(*body.mesh, *skin) : Surface(*body.mesh));
    }
  }

  // The picture looks into the document that is kept here.
  Column(const Column&) = delete;
  Column& operator=(const Column&) = delete;

  double largest() const {
    double most = 0;
    for (const Eigen::VectorXd& pixels : apart_) most = std::max(most, pixels.maxCoeff());
    return most;
  }

  // The state that the path passes through, as far as a picture shows it.
  render::Frame frame(int k, std::int64_t step) const {
    Moment moment;
    moment.state = system_.initial_state();
    moment.state.step = step;
    moment.state.x.head(shown_.run->path.x[k].size()) = shown_.run->path.x[k];
    render::Frame frame = picture_.frame(moment);
    frame.look.lecture = true;  // small pictures, large letters
    frame.look.legend = false;  // of the same colours in each
    return frame;
  }

  // The same bodies, coloured by how many pixels they are away.
  void colour(int k, double reach, bool with_legend, render::Frame& frame) const {
    frame.look.legend = with_legend;
    frame.scale = render::ColourScale{"magma", 0, static_cast<float>(reach), "away from the left", "px"};
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const sim::BodyRange& body = system_.bodies()[i];
      frame.surfaces[i].values = surfaces_[i].values(apart_[k].segment(body.first_node, body.node_count));
    }
    frame.title.clear();
    frame.caption = formatted("at most %.3g px", apart_[k].maxCoeff());
  }

 private:
  static Document document_of(const Comparison& comparison, const Shown& shown) {
    Document document = comparison.scene.document;
    document.title = fitting(shown.name);
    document.exhibits.clear();
    document.look.caption = shown.caption;
    document.look.energies = false;
    return document;
  }

  const sim::System& system_;
  const Shown& shown_;
  Document document_;
  std::vector<Eigen::VectorXd> apart_;
  Picture picture_;
  std::vector<Surface> surfaces_;
};

int common_frames(const std::vector<Shown>& shown) {
  int frames = shown.front().run->path.frames();
  for (const Shown& one : shown) frames = std::min(frames, one.run->path.frames());
  return frames;
}

// All columns at one time, with the camera of the first.
render::Image drawn(const std::deque<Column>& columns, int k, std::int64_t step, double reach,
                    render::Renderer& renderer) {
  std::vector<std::vector<render::Image>> rows(2);
  std::optional<render::Camera> camera;
  for (const Column& column : columns) {
    render::Frame frame = column.frame(k, step);
    if (!camera) camera = frame.camera;
    frame.camera = *camera;
    rows[0].push_back(renderer.draw(frame));
    // What the colours mean stands where all is one colour: the first is no distance from itself.
    column.colour(k, reach, &column == &columns.front(), frame);
    rows[1].push_back(renderer.draw(frame));
  }
  return tiled(rows);
}

}  // namespace

std::vector<Eigen::VectorXd> pixels_apart(const Comparison& comparison, const CaseRun& run, const CaseRun& reference) {
  const sim::Trajectory a = on_screen(comparison, run.path), b = on_screen(comparison, reference.path);
  std::vector<Eigen::VectorXd> apart;
  for (int k = 0; k < std::min(a.frames(), b.frames()); ++k)
    apart.emplace_back((a.x[k] - b.x[k]).reshaped(2, a.x[k].size() / 2).colwise().norm().transpose());
  return apart;
}

int frame_apart_most(const Comparison& comparison, const std::vector<Shown>& shown, int frames) {
  double most = -1;
  int frame = 0;
  for (const Shown& one : shown) {
    const std::vector<Eigen::VectorXd> apart = pixels_apart(comparison, *one.run, *shown.front().run);
    for (std::size_t k = 0; k < apart.size() && k < static_cast<std::size_t>(frames); ++k)
      if (apart[k].maxCoeff() > most) {
        most = apart[k].maxCoeff();
        frame = static_cast<int>(k);
      }
  }
  return frame;
}

void draw_side_by_side(const Comparison& comparison, const std::vector<Shown>& shown, const Options& options,
                       const std::filesystem::path& folder, int frames, const Interrupt& interrupt) {
  const int width = std::max(2, options.width / 4 * 2), height = std::max(2, options.height / 4 * 2);
  std::deque<Column> columns;  // they stay where they are
  for (const Shown& one : shown) columns.emplace_back(comparison, one, *shown.front().run, width, height);
  double reach = least_reach;
  for (const Column& column : columns) reach = std::max(reach, column.largest());
  const auto context = render::make_offscreen_context(options.context);
  render::Renderer renderer(*context, width, height, options.samples);
  const int steps = comparison.scene.system->steps_per_frame();
  std::optional<Video> video;
  if (!options.video.empty() && !options.still)
    video.emplace(options.video,
                  VideoFormat{static_cast<int>(shown.size()) * width, 2 * height,
                              comparison.scene.document.scene.time.fps, static_cast<int>(comparison.stretch.stride)},
                  options.overwrite);
  else
    make_folder(folder);
  const int apart_most = frame_apart_most(comparison, shown, frames);
  for (int k = options.still ? apart_most : 0; k < (options.still ? apart_most + 1 : common_frames(shown)); ++k) {
    if (interrupt.requested()) throw Interrupted{};
    const std::int64_t frame = (k + 1) * comparison.stretch.stride;
    const render::Image image = drawn(columns, k, frame * steps, reach, renderer);
    if (video)
      video->write(image);
    else
      write_atomically(folder / formatted("frame_%05d.png", static_cast<int>(frame)),
                       as_text(render::encode_png(image)), false);
  }
  if (video) video->finish();
}

}  // namespace app
