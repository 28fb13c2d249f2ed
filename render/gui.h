// Widgets of Dear ImGui, beside or over a picture.
#pragma once

#include <functional>
#include <optional>

#include "render/context.h"
#include "render/draw_data.h"
#include "render/frame.h"
#include "render/gl.h"
#include "render/image.h"

struct ImGuiContext;

namespace render {

// Owns a Dear ImGui context of its own, drawn by our painter: the same pixels in a window and without one. What the
// widgets remember (which headers are open) lives as long as this does. Used in the thread of its GL context.
class Gui {
 public:
  // text: height of the letters in pixels.
  Gui(Context& context, float text);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // Other letters from the next frame on.
  void set_text(float text);

  // Where mouse and keys come from: `feed` is called before every frame, with the size of the frame in pixels, `stop`
  // at the end, both with the context in use. Without them there is neither mouse nor key.
  void listen(std::function<void(int width, int height)> feed, std::function<void()> stop);

  // Calls `widgets` in a frame of Dear ImGui and draws what they leave into the bound framebuffer, of this size.
  void draw(int width, int height, const std::function<void()>& widgets);
  // The same into a picture, on black.
  Image picture(int width, int height, const std::function<void()>& widgets);
  // The pixels of the bound framebuffer, of this size.
  Image read(int width, int height) const;

  // Calls f with the context in use.
  void use(const std::function<void()>& f) const;

 private:
  Context& context_;
  GladGLContext gl_;
  ImGuiContext* imgui_;
  float text_ = 0;
  std::optional<DrawDataPainter> painter_;
  std::function<void(int, int)> feed_;
  std::function<void()> stop_;
  GlObject target_texture_, target_;  // of picture
  int target_width_ = 0, target_height_ = 0;
  bool settled_ = false;  // sizes that Dear ImGui learns from a first frame are known
};

// A widget for Gui::draw: a plot, as wide as there is room. text: height of its letters in pixels.
void plot_widget(const Strip& strip, float text);

}  // namespace render
