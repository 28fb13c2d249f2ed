#include "render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "render/legend.h"
#include "render/outline.h"
#include "render/ruler.h"
#include "render/strip.h"

namespace render {
namespace {

// Makes a Dear ImGui context the one in use for as long as this lives.
class InUse {
 public:
  explicit InUse(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) { ImGui::SetCurrentContext(context); }
  ~InUse() { ImGui::SetCurrentContext(before_); }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

 private:
  ImGuiContext* before_;
};

// DejaVu Sans where Debian's fonts-dejavu-core puts it, else the font built into Dear ImGui.
ImFont* load_font(ImFontAtlas& atlas, const char* file, float size) {
  // Latin, Greek, dashes and quotes, super- and subscripts, minus, comparisons.
  static constexpr std::array<ImWchar, 17> glyphs = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x203a,
                                                     0x2070, 0x209c, 0x2190, 0x2193, 0x2202, 0x221e,
                                                     0x2248, 0x2248, 0x2264, 0x2265, 0};
  const std::filesystem::path path = std::filesystem::path("/usr/share/fonts/truetype/dejavu") / file;
  ImFontConfig config;
  config.OversampleH = 2;
  config.PixelSnapH = true;
  std::error_code none;
  if (std::filesystem::exists(path, none)) {
    ImFont* font = atlas.AddFontFromFileTTF(path.c_str(), size, &config, glyphs.data());
    if (font != nullptr) return font;
  }
  config.SizePixels = size;
  return atlas.AddFontDefault(&config);
}

constexpr float title_scale = 1.3F;

}  // namespace

Overlay::Overlay(const GladGLContext& gl, int width, int height) : imgui_(nullptr) {
  page_.width = static_cast<float>(width);
  page_.height = static_cast<float>(height);
  // Legible on a small picture, in proportion on a large one.
  page_.size = std::round(std::max(11.0F, 0.029F * std::min(page_.height, 0.75F * page_.width)));
  page_.margin = std::round(0.9F * page_.size);
  ImGuiContext* before = ImGui::GetCurrentContext();
  imgui_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(before);
  const InUse in_use(imgui_);
  load_fonts();
  painter_.emplace(gl, *ImGui::GetIO().Fonts);
}

Overlay::~Overlay() {
  ImGui::DestroyContext(imgui_);
}

void Overlay::load_fonts() {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // it must not leave files behind
  io.LogFilename = nullptr;
  io.DisplaySize = {page_.width, page_.height};
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  page_.text = load_font(*io.Fonts, "DejaVuSans.ttf", page_.size);
  page_.bold = load_font(*io.Fonts, "DejaVuSans-Bold.ttf", std::round(title_scale * page_.size));
}

void Overlay::draw(const Frame& frame, const View& view) {
  const InUse in_use(imgui_);
  ImGui::NewFrame();
  page_.list = ImGui::GetBackgroundDrawList();
  const bool coloured = std::any_of(frame.surfaces.begin(), frame.surfaces.end(),
                                    [](const Surface& surface) { return !surface.values.empty(); });
  draw_outlines(page_, frame, view);
  if (view.orthographic && frame.look.axes) draw_axes(page_, view, frame.look.length);
  if (view.orthographic && frame.look.scale_bar) draw_scale_bar(page_, view, frame.look.length);
  draw_labels(frame.labels, view);
  const ImVec2 strips = draw_strips(page_, frame.strips);
  const bool bar = view.orthographic && frame.look.scale_bar;
  const float bottom = std::min(strips.y, bar ? page_.height - 5.5F * page_.size : page_.height);
  if (frame.scale && frame.look.legend && coloured) draw_legend(page_, *frame.scale, bottom - 0.5F * page_.margin);
  draw_words(frame, view, strips);
  ImGui::Render();
  painter_->draw(*ImGui::GetDrawData());
}

void Overlay::draw_labels(const std::vector<Label>& labels, const View& view) const {
  const float pad = 0.4F * page_.size;
  for (const Label& label : labels) {
    const Eigen::Vector3f at =
        view.to_window(to_vector(label.at), static_cast<int>(page_.width), static_cast<int>(page_.height));
    if (!view.orthographic && at.z() < view.near_distance) continue;
    const ImVec2 size = page_.measure(label.text);
    const float top = at.y() - 1.9F * page_.size;
    page_.lay_plate({at.x() - size.x / 2 - pad, top - pad / 2}, {at.x() + size.x / 2 + pad, top + size.y + pad / 2});
    page_.write(at.x(), top, label.text, Align::centre);
  }
}

void Overlay::draw_words(const Frame& frame, const View& view, ImVec2 strips) const {
  const float pad = 0.4F * page_.size;
  Page heading = page_;
  heading.text = page_.bold;
  const bool axes = view.orthographic && frame.look.axes;
  const float left = axes ? 3.6F * page_.size + page_.margin : page_.margin;
  if (!frame.title.empty()) {
    heading.write(left, 0.8F * page_.margin, frame.title, Align::left, Page::ink, title_scale,
                  page_.width - left - page_.margin);
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
