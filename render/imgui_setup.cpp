#include "render/imgui_setup.h"

#include <array>
#include <filesystem>

namespace render {

ImGuiContext* make_imgui() {
  ImGuiContext* const before = ImGui::GetCurrentContext();
  ImGuiContext* const imgui = ImGui::CreateContext();
  ImGui::SetCurrentContext(imgui);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  ImGui::SetCurrentContext(before);
  return imgui;
}

ImFont* load_font(ImFontAtlas& atlas, const char* file, float size) {
  // Latin, Greek, dashes and quotes, super- and subscripts, arrows, what formulas are written with.
  static constexpr std::array<ImWchar, 27> glyphs = {
      0x20,   0xff,   0x2b0,  0x2b8,  0x370,  0x3ff,  0x1d2c, 0x1d6a, 0x1e8a, 0x1e8d, 0x2010, 0x203a, 0x2070, 0x209c,
      0x2190, 0x2193, 0x21d2, 0x21d4, 0x2200, 0x222b, 0x2248, 0x2248, 0x2260, 0x2265, 0x2c7c, 0x2c7c, 0};
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

}  // namespace render
