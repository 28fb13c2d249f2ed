#include "render/gui.h"

#include "render/imgui_setup.h"
#include "render/letters.h"
#include "render/page.h"
#include "render/strip.h"

namespace render {
namespace {

// Calm and light, to stand beside the picture.
void set_style(float text) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = {};
  ImGui::StyleColorsLight();
  style.ScaleAllSizes(text / 13);
  style.WindowRounding = 0;
  style.FrameRounding = 0.2F * text;
  style.WindowBorderSize = 0;
  style.Colors[ImGuiCol_Text] = {0.11F, 0.13F, 0.16F, 1};
  style.Colors[ImGuiCol_WindowBg] = {0.97F, 0.975F, 0.98F, 1};
  style.Colors[ImGuiCol_PopupBg] = {1, 1, 1, 0.98F};
  style.Colors[ImGuiCol_FrameBg] = {0.88F, 0.90F, 0.92F, 1};
  style.Colors[ImGuiCol_Header] = {0.82F, 0.87F, 0.92F, 1};
  style.Colors[ImGuiCol_Button] = {0.78F, 0.85F, 0.92F, 1};
}

}  // namespace

Gui::Gui(Context& context, float text) : context_(context), gl_(load_gl(context)), imgui_(make_imgui()) {
  set_text(text);
}

void Gui::set_text(float text) {
  if (text == text_) return;
  text_ = text;
  const InUse in_use(imgui_);
  set_style(text);
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  Letters letters;
  load_font(fonts, "DejaVuSans.ttf", text, letters.ranges());
  painter_.reset();
  painter_.emplace(gl_, fonts);
}

Gui::~Gui() {
  context_.make_current();
  painter_.reset();
  target_ = {};
  target_texture_ = {};
  if (stop_) use(stop_);
  ImGui::DestroyContext(imgui_);
}

void Gui::listen(std::function<void(int, int)> feed, std::function<void()> stop) {
  feed_ = std::move(feed);
  stop_ = std::move(stop);
}

void Gui::draw(int width, int height, const std::function<void()>& widgets) {
  const InUse in_use(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  for (; true; settled_ = true) {
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    if (feed_) feed_(width, height);
    ImGui::NewFrame();
    widgets();
    ImGui::Render();
    if (settled_) break;
  }
  gl_.Viewport(0, 0, width, height);
  painter_->draw(*ImGui::GetDrawData());
}

Image Gui::picture(int width, int height, const std::function<void()>& widgets) {
  context_.make_current();
  if (width != target_width_ || height != target_height_) {
    target_texture_ = make_texture(gl_, {GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST});
    target_ = make_framebuffer(gl_);
    target_width_ = width;
    target_height_ = height;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target_.name());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_texture_.name(), 0);
    check_framebuffer(gl_, "widgets");
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target_.name());
  gl_.ClearColor(0, 0, 0, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  draw(width, height, widgets);
  return read(width, height);
}

Image Gui::read(int width, int height) const {
  return read_pixels(gl_, width, height);
}

void Gui::use(const std::function<void()>& f) const {
  const InUse in_use(imgui_);
  f();
}

void plot_widget(const Strip& strip, float text) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high = {low.x + ImGui::GetContentRegionAvail().x, low.y + 6.5F * text};
  Page page;
  page.list = ImGui::GetWindowDrawList();
  page.text = page.bold = ImGui::GetFont();
  page.size = text;
  draw_strip(page, strip, low, high);
  ImGui::Dummy({high.x - low.x, high.y - low.y + 0.3F * text});
}

}  // namespace render
