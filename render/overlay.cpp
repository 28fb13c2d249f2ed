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
#include "render/ruler.h"
#include "render/strip.h"

namespace render {
namespace {

constexpr float title_scale = 1.3F;

// Dear ImGui's size of a font is from the top of its highest letters to the bottom of its lowest, 1.164 em of DejaVu
// Sans; a lecture's letters have an em of 1/28, 1/24 and 1/20 of the height.
constexpr float per_em = 1.164F;

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
  const float height = std::min(page_.height, 0.75F * page_.width);
  // Legible on a small picture, in proportion on a large one; a lecture's pages are the same at every size.
  const float side = static_cast<float>(measure_of(page_.width, page_.height));
  page_.size = std::round(lecture ? std::max(6.0F, per_em * side / 28) : std::max(11.0F, 0.029F * height));
  page_.margin = std::round((lecture ? 0.6F : 0.9F) * page_.size);
  page_.text = load_font(*io.Fonts, "DejaVuSans.ttf", page_.size);
  page_.bold =
      load_font(*io.Fonts, "DejaVuSans-Bold.ttf", std::round((lecture ? 28.0F / 24 : title_scale) * page_.size));
  if (lecture) formula_ = load_font(*io.Fonts, "DejaVuSans.ttf", std::round(28.0F / 20 * page_.size));
  painter_.reset();
  painter_.emplace(gl_, *io.Fonts);
}

void Overlay::draw(const Frame& frame, const View& view) {
  const InUse in_use(imgui_);
  if (frame.look.lecture != lecture_) load_fonts(frame.look.lecture);
  ImGui::NewFrame();
  page_.list = ImGui::GetBackgroundDrawList();
  const bool coloured = std::any_of(frame.surfaces.begin(), frame.surfaces.end(),
                                    [](const Surface& surface) { return !surface.values.empty(); });
  draw_outlines(page_, frame, view);
  draw_hatched_planes(page_, frame, view);
  if (view.orthographic && frame.look.axes) draw_axes(page_, view, frame.look.length);
  if (view.orthographic && frame.look.scale_bar) draw_scale_bar(page_, view, frame.look.length);
  draw_labels(frame, view);
  if (frame.sheet) draw_sheet(frame);
  const ImVec2 strips = draw_strips(page_, frame.strips);
  const bool bar = view.orthographic && frame.look.scale_bar;
  const float bottom = std::min(strips.y, bar ? page_.height - 5.5F * page_.size : page_.height);
  if (frame.scale && frame.look.legend && coloured) draw_legend(page_, *frame.scale, bottom - 0.5F * page_.margin);
  draw_words(frame, view, strips);
  ImGui::Render();
  painter_->draw(*ImGui::GetDrawData());
}

void Overlay::draw_labels(const Frame& frame, const View& view) const {
  const float pad = 0.4F * page_.size;
  const float highest = frame.title.empty() ? 0 : 0.8F * page_.margin + title_scale * page_.size + pad;
  for (const Label& label : frame.labels) {
    const Eigen::Vector3f at =
        view.to_window(to_vector(label.at), static_cast<int>(page_.width), static_cast<int>(page_.height));
    if (!view.orthographic && at.z() < view.near_distance) continue;
    const ImVec2 size = page_.measure(label.text);
    const float top = std::max(at.y() - 1.9F * page_.size, highest);
    const ImVec2 low{at.x() - size.x / 2 - pad, top - pad / 2}, high{at.x() + size.x / 2 + pad, top + size.y + pad / 2};
    page_.lay_plate(low, high);
    // A lecture's words are read on any colour.
    if (lecture_) page_.list->AddRectFilled(low, high, IM_COL32_WHITE, 0.35F * page_.size);
    page_.write(at.x(), top, label.text, Align::centre, lecture_ ? colour_of(Ink::black) : Page::ink);
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

void Overlay::draw_words(const Frame& frame, const View& view, ImVec2 strips) const {
  const float pad = 0.4F * page_.size;
  Page heading = page_;
  heading.text = page_.bold;
  const bool axes = view.orthographic && frame.look.axes;
  const float left = axes ? 3.6F * page_.size + page_.margin : page_.margin;
  if (!frame.title.empty()) {
    heading.write(left, 0.8F * page_.margin, frame.title, Align::left, lecture_ ? colour_of(Ink::black) : Page::ink,
                  lecture_ ? 28.0F / 24 : title_scale, page_.width - left - page_.margin);
  }
  if (frame.caption.empty()) return;
  // Above the lower axis, if there is one; beside the strips where it fits, else above them.
  const bool beside = page_.measure(frame.caption).x <= strips.x - left - page_.margin;
  const float wrap = beside ? 0 : page_.width - left - page_.margin;
  const ImVec2 size = page_.measure(frame.caption, 1, wrap);
  const bool lifted = !beside && !frame.strips.empty();
  const float bottom = lifted ? strips.y - page_.margin : page_.height - page_.margin - (axes ? 2 * page_.size : 0);
  page_.lay_plate({left - pad, bottom - size.y - pad / 2}, {left + size.x + pad, bottom + pad / 2});
  page_.write(left, bottom - size.y, frame.caption, Align::left, Page::ink, 1, wrap);
}

}  // namespace render
