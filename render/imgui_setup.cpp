#include "render/imgui_setup.h"

#include <filesystem>

namespace render {
namespace {

constexpr const char* dejavu = "/usr/share/fonts/truetype/dejavu";

}  // namespace

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

bool has_dejavu() {
  std::error_code none;
  return std::filesystem::exists(std::filesystem::path(dejavu) / "DejaVuSans.ttf", none);
}

ImFont* load_font(ImFontAtlas& atlas, const char* file, float size, const ImWchar* letters) {
  const std::filesystem::path path = std::filesystem::path(dejavu) / file;
  ImFontConfig config;
  config.OversampleH = 2;
  config.PixelSnapH = true;
  std::error_code none;
  if (std::filesystem::exists(path, none)) {
    ImFont* font = atlas.AddFontFromFileTTF(path.c_str(), size, &config, letters);
    if (font != nullptr) return font;
  }
  config.SizePixels = size;
  return atlas.AddFontDefault(&config);
}

}  // namespace render
