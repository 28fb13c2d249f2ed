// What every context of Dear ImGui is set up with.
#pragma once

#include <imgui.h>

namespace render {

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

// A new context that leaves no files behind; the one in use stays in use.
ImGuiContext* make_imgui();

// Whether the font is where Debian's fonts-dejavu-core puts it.
bool has_dejavu();

// A file of DejaVu ("DejaVuSans.ttf") with these letters, else the font built into Dear ImGui. The list of letters must
// live until the atlas is built.
ImFont* load_font(ImFontAtlas& atlas, const char* file, float size, const ImWchar* letters);

}  // namespace render
