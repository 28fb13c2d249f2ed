// Text and plots over a picture.
#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

#include "render/draw_data.h"
#include "render/frame.h"
#include "render/letters.h"
#include "render/page.h"
#include "render/view.h"

namespace render {

// Owns a Dear ImGui context, with fonts baked at the sizes that the picture needs. Dear ImGui keeps a pointer to the
// context in use; it is set only during calls, so overlays may be used in turn, but not in two threads at once.
class Overlay {
 public:
  Overlay(const GladGLContext& gl, int width, int height);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  // Draws title, caption, labels, legend, strips and rulers of the frame into the bound framebuffer.
  void draw(const Frame& frame, const View& view);

 private:
  // For the usual look, or for the lecture's.
  void load_fonts(bool lecture);
  // Fonts are baked anew where a frame brings letters that none before it had.
  void learn_letters(const Frame& frame);
  void draw_sheet(const Frame& frame) const;
  float title_end(const Frame& frame) const;
  // `legend`: its upper left corner; `corner`: that of what stands at the lower right.
  void draw_labels(const Frame& frame, const View& view, ImVec2 legend) const;
  void draw_words(const Frame& frame, const View& view, ImVec2 corner, ImVec2 legend) const;

  const GladGLContext& gl_;
  ImGuiContext* imgui_;
  Letters letters_;
  Page page_;
  bool lecture_ = false;       // what the fonts were loaded for
  ImFont* formula_ = nullptr;  // of the lecture
  std::optional<DrawDataPainter> painter_;
};

}  // namespace render
