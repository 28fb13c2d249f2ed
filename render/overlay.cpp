#include "render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/block.h"
#include "render/diagram.h"
#include "render/hatch.h"
#include "render/imgui_setup.h"
#include "render/legend.h"
#include "render/outline.h"
#include "render/room.h"
#include "render/ruler.h"
#include "render/strip.h"

namespace render {
namespace {

constexpr float title_scale = 1.3F, least_title_scale = 0.9F;

// A title that is a little too long for one line is smaller.
float fitting_title(const Page& heading, const std::string& title, float width) {
  return std::clamp(width / heading.measure(title).x, least_title_scale, title_scale);
}

}  // namespace

Overlay::Overlay(const GladGLContext& gl, int width, int height) : gl_(gl), imgui_(nullptr) {
  page_.width = static_cast<float>(width);
  page_.height = static_cast<float>(height);
  imgui_ = make_imgui();
  const InUse in_use(imgui_);
  load_fonts(false);
}

Overlay::~Overlay() {
  ImGui::DestroyContext(imgui_);
}

void Overlay::load_fonts(bool lecture) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {page_.width, page_.height};
  io.Fonts->Clear();
  lecture_ = lecture;
  page_.size = text_size(page_.width, page_.height, lecture);
  page_.margin = std::round((lecture ? 0.6F : 0.9F) * page_.size);
  const float bold = std::round((lecture ? 28.0F / 24 : title_scale) * page_.size);
  const ImWchar* letters = letters_.ranges();
  page_.text = load_font(*io.Fonts, "DejaVuSans.ttf", page_.size, letters);
  page_.bold = load_font(*io.Fonts, "DejaVuSans-Bold.ttf", bold, letters);
  if (lecture) formula_ = load_font(*io.Fonts, "DejaVuSans.ttf", std::round(28.0F / 20 * page_.size), letters);
  painter_.reset();
  painter_.emplace(gl_, *io.Fonts);
}

void Overlay::learn_letters(const Frame& frame) {
  bool is_new = letters_.learn(frame.title);
  is_new = letters_.learn(frame.caption) || is_new;
  for (const Label& label : frame.labels) is_new = letters_.learn(label.text) || is_new;
  for (const Strip& strip : frame.strips) is_new = letters_.learn(strip.title) || is_new;
  if (frame.sheet) is_new = letters_.learn(frame.sheet->formula) || is_new;
  if (is_new || frame.look.lecture != lecture_) load_fonts(frame.look.lecture);
}

void Overlay::draw(const Frame& frame, const View& view) {
  const InUse in_use(imgui_);
  learn_letters(frame);
  ImGui::NewFrame();
  page_.list = ImGui::GetBackgroundDrawList();
  const bool coloured = std::any_of(frame.surfaces.begin(), frame.surfaces.end(),
                                    [](const Surface& surface) { return !surface.values.empty(); });
  draw_outlines(page_, frame, view);
  draw_hatched_planes(page_, frame, view);
  const bool axes = view.orthographic && frame.look.axes, bar = view.orthographic && frame.look.scale_bar;
  if (axes) draw_axes(page_, view, frame, title_end(frame) + page_.margin / 2);
  if (frame.sheet) draw_sheet(frame);
  // Each leaves what is free of the right side to the next one: its lower right corner.
  ImVec2 corner = draw_strips(page_, frame.strips, axes ? axes_below * page_.size : 0);
  if (bar) {
    const float below = frame.strips.empty() ? (axes ? axes_below : 0.6F) * page_.size : page_.margin;
    const ImVec2 end{page_.width - page_.margin, corner.y - below};
    const ImVec2 begin = draw_scale_bar(page_, view, frame.look.length, end);
    corner = {std::min(corner.x, begin.x), begin.y};
  }
  ImVec2 legend{page_.width, page_.height};
  if (frame.scale && frame.look.legend && coloured)
    legend = draw_legend(page_, *frame.scale, corner.y - 0.5F * page_.margin);
  draw_labels(frame, view, legend);
  draw_words(frame, view, corner, legend);
  ImGui::Render();
  painter_->draw(*ImGui::GetDrawData());
}

// The lower edge of a title of one line.
float Overlay::title_end(const Frame& frame) const {
  return frame.title.empty() ? 0 : 0.8F * page_.margin + title_scale * page_.size;
}

// Above or below their points, but inside the picture, left of the legend and clear of each other: one that would cover
// those before it stands above or, where the title is, below them.
void Overlay::draw_labels(const Frame& frame, const View& view, ImVec2 legend) const {
  const float pad = 0.4F * page_.size, highest = title_end(frame) + pad;
  std::vector<ImVec4> taken;  // x and y of the upper left corner, x and y of the lower right one
  for (const Label& label : frame.labels) {
    const Eigen::Vector3f at =
        view.to_window(to_vector(label.at), static_cast<int>(page_.width), static_cast<int>(page_.height));
    if (!view.orthographic && at.z() < view.near_distance) continue;
    const ImVec2 size = page_.measure(label.text);
    const float half = size.x / 2 + pad, height = size.y + pad;
    const float lowest = page_.height - page_.margin - height;
    float top = label.below ? std::min(at.y() + 0.5F * page_.size, lowest)
                            : std::max(at.y() - 1.9F * page_.size, highest) - pad / 2;
    const float end = top + height > legend.y ? legend.x : page_.width;
    const float x = std::clamp(at.x(), std::min(half, end / 2), std::max(end - half, end / 2));
    // What only touches, but for round-off, does not cover: it could not be moved any further.
    const auto covers = [&](const ImVec4& other) {
      constexpr float touch = 0.1F;  // pixels
      return x - half < other.z && x + half > other.x && top + touch < other.w && top + height > other.y + touch;
    };
    bool down = false;
    for (auto other = taken.begin(); other != taken.end();) {
      if (covers(*other)) {
        down = down || other->y - height < highest - pad / 2;
        top = down ? other->w : other->y - height;
        other = taken.begin();
      } else {
        ++other;
      }
    }
    taken.push_back({x - half, top, x + half, top + height});
    const ImVec2 low{x - half, top}, high{x + half, top + height};
    page_.lay_plate(low, high);
    // A lecture's words are read on any colour.
    if (lecture_) page_.list->AddRectFilled(low, high, IM_COL32_WHITE, 0.35F * page_.size);
    page_.write(x, top + pad / 2, label.text, Align::centre, lecture_ ? colour_of(Ink::black) : Page::ink);
  }
}

// Diagrams, the column of numbers, the formula and the proof below them.
void Overlay::draw_sheet(const Frame& frame) const {
  const Sheet& sheet = *frame.sheet;
  for (const Diagram& diagram : sheet.diagrams) draw_diagram(page_, diagram);
  const float top = 0.8F * page_.margin + (frame.title.empty() ? 0 : 1.6F * page_.size);
  const float bottom = page_.height - page_.margin;
  draw_blocks(page_, sheet, static_cast<float>(sheet.column) * page_.width, top, bottom - 1.9F * page_.size);
  Page formula = page_;
  if (lecture_) {
    formula.text = formula_;
    formula.size = 28.0F / 20 * page_.size;
  }
  formula.write(page_.margin, bottom - formula.size, sheet.formula, Align::left, colour_of(Ink::black));
  draw_proof(page_, sheet.proof_label, sheet.proof, {page_.width - page_.margin, bottom},
             page_.margin + formula.measure(sheet.formula).x);
}

void Overlay::draw_words(const Frame& frame, const View& view, ImVec2 corner, ImVec2 legend) const {
  const float pad = 0.4F * page_.size;
  Page heading = page_;
  heading.text = page_.bold;
  const bool axes = view.orthographic && frame.look.axes;
  const float left = axes ? 3.6F * page_.size + page_.margin : page_.margin;
  if (!frame.title.empty()) {
    const float wrap = (legend.y < title_end(frame) ? legend.x : page_.width) - left - page_.margin;
    heading.write(left, 0.8F * page_.margin, frame.title, Align::left, lecture_ ? colour_of(Ink::black) : Page::ink,
                  lecture_ ? 28.0F / 24 : fitting_title(heading, frame.title, wrap), wrap);
  }
  if (frame.caption.empty()) return;
  // Above the lower axis, if there is one; beside strips and scale bar where it fits, else above them.
  const bool beside = page_.measure(frame.caption).x <= corner.x - left - page_.margin;
  const float wrap = beside ? 0 : page_.width - left - page_.margin;
  const ImVec2 size = page_.measure(frame.caption, 1, wrap);
  const bool lifted = !beside && corner.y < page_.height;
  const float bottom = lifted ? corner.y - page_.margin : page_.height - page_.margin - (axes ? 2 * page_.size : 0);
  page_.lay_plate({left - pad, bottom - size.y - pad / 2}, {left + size.x + pad, bottom + pad / 2});
  page_.write(left, bottom - size.y, frame.caption, Align::left, Page::ink, 1, wrap);
}

}  // namespace render
