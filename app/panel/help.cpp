#include <imgui.h>

#include <array>
#include <utility>

#include "app/panel/panel.h"

namespace app {

void draw_help(int width, int height) {
  constexpr std::array<std::pair<const char*, const char*>, 15> lines = {
      {{"Space", "play, pause"},
       {"Right", "one step"},
       {"Left", "one step back"},
       {"Backspace", "reset: the initial state"},
       {"Page down, Page up", "the next page of a deck, and the one before"},
       {"W", "wireframe"},
       {"Tab", "panel"},
       {"Ctrl+L", "read the file again"},
       {"Ctrl+S", "save the scene"},
       {"Ctrl+P", "screenshot"},
       {"Ctrl+Q", "quit"},
       {"left drag", "orbit"},
       {"right drag", "pan"},
       {"wheel", "zoom"},
       {"Ctrl + left drag", "pull the body"}}};
  ImGui::SetNextWindowPos({0.5F * static_cast<float>(width), 0.5F * static_cast<float>(height)}, 0, {0.5F, 0.5F});
  ImGui::Begin("keys", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings);
  for (const auto& [key, what] : lines) {
    ImGui::TextUnformatted(key);
    ImGui::SameLine(10 * ImGui::GetFontSize());
    ImGui::TextUnformatted(what);
  }
  ImGui::End();
}

}  // namespace app
