#include "app/panel/panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panel/plots.h"
#include "app/panel/sections.h"
#include "app/run/contact_totals.h"
#include "app/scene/key_reference.h"

namespace app {
namespace {

const ImVec4 soft = {0.36F, 0.39F, 0.43F, 1};
const ImVec4 warning = {0.70F, 0.20F, 0.05F, 1};

const char* effect_text(Effect effect) {
  switch (effect) {
    case Effect::look:
    case Effect::motion:
      return "Changes at once.";
    case Effect::start:
      return "Tells at the next reset.";
    case Effect::restart:
      return "Cannot change while bodies move: waits for the restart.";
  }
  return "";
}

void explain(const Key& key, const std::string& path) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(24 * ImGui::GetFontSize());
  ImGui::TextUnformatted(path.c_str());
  ImGui::TextWrapped("%s", std::string(key.meaning).c_str());
  std::string facts = kind_text(key);
  if (!key.unit.empty()) facts.append(", ").append(key.unit);
  if (const std::string range = key.range.text(); !range.empty()) facts += ", " + range;
  ImGui::TextColored(soft, "%s", facts.c_str());
  ImGui::TextColored(soft, "default: %s", default_text(key, blank_document()).c_str());
  ImGui::TextColored(soft, "%s", effect_text(*key.effect));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool button(const char* label, const char* help) {
  const bool pressed = ImGui::Button(label);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::SameLine();
  return pressed;
}

void draw_terms(const sim::System& system) {
  if (!ImGui::CollapsingHeader("terms of the energy", ImGuiTreeNodeFlags_DefaultOpen)) return;
  for (const sim::TermInfo& term : system.terms()) {
    ImGui::TextWrapped("%s", term.name.c_str());
    ImGui::Indent();
    ImGui::PushStyleColor(ImGuiCol_Text, soft);
    ImGui::TextWrapped("%s", term.what.c_str());
    ImGui::PopStyleColor();
    ImGui::Unindent();
  }
}

}  // namespace

float Panel::text_size(int width, int height) {
  const auto shorter = static_cast<float>(std::min(height, 3 * width / 4));
  return std::max(11.0F, std::round(0.021F * shorter));
}

int Panel::width(int width, int height) {
  return std::min(static_cast<int>(24 * text_size(width, height)), width / 2);
}

PanelRequests Panel::draw(const PanelState& state, int width, int height) {
  PanelRequests requests;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(width), static_cast<float>(height)});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  draw_head(state, requests);
  if (ImGui::CollapsingHeader("plots", ImGuiTreeNodeFlags_DefaultOpen)) {
    draw_plots(state.samples, state.clock, ImGui::GetFontSize());
  }
  draw_keys(state, requests);
  draw_terms(state.system);
  ImGui::End();
  return requests;
}

void Panel::draw_head(const PanelState& state, PanelRequests& requests) const {
  const auto ask = [&](const char* label, const char* help, Action action) {
    if (button(label, help)) requests.actions.push_back(action);
  };
  ask(state.playing ? "Pause" : "Play ", "Space", Action::play);
  ask("Back", "the state before the last step: Left", Action::back);
  ask("Step", "one step: Right", Action::step);
  ask("Reset", "the initial state, values as they are: Backspace", Action::reset);
  ImGui::NewLine();
  ask("Save scene", "as a TOML file that `ritz record` reads: Ctrl+S", Action::save);
  ask("Reload", "the file, all changes dropped: Ctrl+L", Action::reload);
  ask("Help", "F1", Action::help);
  ImGui::NewLine();
  ImGui::Text("t = %.4g s, step %lld", state.t, static_cast<long long>(state.step));
  if (state.clock && state.playing && state.factor < 0.95) {
    ImGui::SameLine();
    ImGui::TextColored(warning, "%.2g of real time", state.factor);
  }
  if (state.system.contact_pairs() > 0 && !state.samples.empty())
    ImGui::TextUnformatted(contact_text(state.samples.back().contacts).c_str());
  if (!state.waiting.empty()) {
    if (ImGui::Button("Restart with changes")) requests.actions.push_back(Action::restart);
    for (const Override& each : state.waiting) ImGui::TextColored(warning, "%s", each.origin.c_str());
  }
  if (state.message.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, warning);
  ImGui::TextWrapped("%s", state.message.c_str());
  ImGui::PopStyleColor();
}

void Panel::draw_keys(const PanelState& state, PanelRequests& requests) {
  for (const Section& section : sections(state.document)) {
    const ImGuiTreeNodeFlags open = section.open ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    if (!ImGui::CollapsingHeader(section.title.c_str(), open)) continue;
    ImGui::PushID(section.path.c_str());
    for (const Group& group : section.groups) draw_group(group, state, requests);
    ImGui::PopID();
  }
}

void Panel::draw_group(const Group& group, const PanelState& state, PanelRequests& requests) {
  if (!group.name.empty()) {
    const ImGuiTreeNodeFlags open = group.open ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    if (!ImGui::TreeNodeEx(group.name.c_str(), open | ImGuiTreeNodeFlags_SpanAvailWidth)) return;
  }
  for (const Entry& entry : group.entries) draw_entry(entry, state, requests);
  if (!group.name.empty()) ImGui::TreePop();
}

void Panel::draw_entry(const Entry& entry, const PanelState& state, PanelRequests& requests) {
  const Key& key = *entry.key;
  ImGui::PushID(entry.path.c_str());
  ImGui::AlignTextToFramePadding();
  const bool waits = std::ranges::find(state.waiting, entry.path, &Override::key) != state.waiting.end();
  std::string label = entry.name;
  if (!key.unit.empty()) label.append(" [").append(key.unit).append("]");
  ImGui::TextColored(waits ? warning : ImGui::GetStyleColorVec4(ImGuiCol_Text), "%s", label.c_str());
  explain(key, entry.path);
  ImGui::SameLine(0.5F * ImGui::GetWindowWidth());
  const std::optional<std::string> changed =
      draw_field(key, entry.path, entry.value, state.document.scene.dimension, edit_);
  explain(key, entry.path);
  if (changed) requests.changes.push_back({entry.path, *changed});
  ImGui::PopID();
}

}  // namespace app
