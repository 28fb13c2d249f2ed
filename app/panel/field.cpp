#include "app/panel/field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/scene/value_text.h"

namespace app {
namespace {

constexpr const char* format = "%.6g";

// A slider shows where in its range a value is; wide ranges are dragged.
bool slides(const Range& range) {
  constexpr double widest = 200;
  return std::isfinite(range.low) && std::isfinite(range.high) && range.high - range.low <= widest &&
         !(range.low_open && range.low == 0);
}

// Counts of some things, of which one more matters where there are few.
bool counts(const Range& range) {
  constexpr double most = 1000;
  return range.low >= 1 && range.high <= most;
}

void draw_number(const Range& range, double& x) {
  if (slides(range)) {
    const double margin = 1e-3 * (range.high - range.low);
    const double low = range.low + (range.low_open ? margin : 0), high = range.high - (range.high_open ? margin : 0);
    ImGui::SliderScalar("##value", ImGuiDataType_Double, &x, &low, &high, format);
    return;
  }
  // A hundredth of the value for each pixel.
  const float speed = static_cast<float>(std::max(std::abs(x), 1e-3) * 0.01);
  ImGui::DragScalar("##value", ImGuiDataType_Double, &x, speed, nullptr, nullptr, format);
}

void draw_integer(const Key& key, std::int64_t& n) {
  if (key.kind == Kind::substeps && n == 0) {
    // "auto" until it is given a number.
    ImGui::DragScalar("##value", ImGuiDataType_S64, &n, 0.05F, nullptr, nullptr, "auto");
  } else if (counts(key.range)) {
    const auto low = static_cast<std::int64_t>(key.range.low), high = static_cast<std::int64_t>(key.range.high);
    ImGui::SliderScalar("##value", ImGuiDataType_S64, &n, &low, &high, nullptr, ImGuiSliderFlags_Logarithmic);
  } else {
    ImGui::DragScalar("##value", ImGuiDataType_S64, &n, 0.05F);
  }
  const auto least = static_cast<std::int64_t>(key.kind == Kind::substeps ? 0 : key.range.low);
  n = std::clamp(n, least, static_cast<std::int64_t>(key.range.high));
}

void draw_numbers(const Key& key, std::vector<double>& list, int dimension) {
  const auto row = [](const char* label, double* first, int count) {
    ImGui::InputScalarN(label, ImGuiDataType_Double, first, count, nullptr, nullptr, format);
  };
  // The first `shown` of every `stride` numbers on a line of their own; of long lists as many as a panel has room for.
  const auto rows = [&](std::vector<double>& all, int stride, int shown) {
    constexpr std::size_t most = 12;
    const std::size_t lines = std::min(most, all.size() / static_cast<std::size_t>(stride));
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < lines; ++i) {
      ImGui::PushID(static_cast<int>(i));
      ImGui::SetNextItemWidth(-1);
      row("##row", all.data() + i * static_cast<std::size_t>(stride), shown);
      ImGui::PopID();
    }
    ImGui::EndGroup();
  };
  switch (key.kind) {
    case Kind::point:
    case Kind::direction:
      return row("##value", list.data(), dimension);
    case Kind::box:
      ImGui::BeginGroup();
      row("##low", list.data(), dimension);
      ImGui::SetNextItemWidth(-1);
      row("##high", list.data() + 3, dimension);
      return ImGui::EndGroup();
    case Kind::ball:
      ImGui::BeginGroup();
      row("##centre", list.data(), dimension);
      ImGui::SetNextItemWidth(-1);
      row("##radius", list.data() + 3, 1);
      return ImGui::EndGroup();
    case Kind::matrix:
      return rows(list, dimension, dimension);
    case Kind::points:
      return rows(list, 3, dimension);
    default:
      return row("##value", list.data(), static_cast<int>(list.size()));
  }
}

// True when another one was chosen.
bool draw_choice(const Key& key, std::string& chosen) {
  bool changed = false;
  if (!ImGui::BeginCombo("##value", chosen.c_str())) return false;
  for (const std::string_view choice : key.choices()) {
    const bool is_it = choice == chosen;
    if (ImGui::Selectable(std::string(choice).c_str(), is_it) && !is_it) {
      chosen = choice;
      changed = true;
    }
  }
  ImGui::EndCombo();
  return changed;
}

// Texts that are typed where a key is absent: TOML.
std::optional<std::string> draw_absent(const Key& key, const std::string& path, std::optional<Edit>& edit) {
  std::string text = edit && edit->path == path ? std::get<std::string>(edit->value) : std::string();
  ImGui::InputTextWithHint("##value", std::string(key.absent).c_str(), &text);
  const bool done = ImGui::IsItemDeactivatedAfterEdit();
  if (ImGui::IsItemActive()) edit = {path, text};
  if (!done || text.empty()) return std::nullopt;
  edit.reset();
  return text;
}

// True when the value has changed for good.
bool draw_value(const Key& key, Value& value, int dimension) {
  if (auto* x = std::get_if<bool>(&value)) return ImGui::Checkbox("##value", x);
  if (auto* x = std::get_if<std::string>(&value)) {
    if (key.kind == Kind::choice) return draw_choice(key, *x);
    ImGui::InputText("##value", x);
  } else if (auto* n = std::get_if<std::int64_t>(&value)) {
    draw_integer(key, *n);
  } else if (auto* number = std::get_if<double>(&value)) {
    draw_number(key.range, *number);
  } else if (const auto* names = std::get_if<std::vector<std::string>>(&value)) {
    ImGui::TextUnformatted(value_text(key, *names, dimension).c_str());
  } else {
    draw_numbers(key, std::get<std::vector<double>>(value), dimension);
  }
  return ImGui::IsItemDeactivatedAfterEdit();
}

}  // namespace

std::optional<std::string> draw_field(const Key& key, const std::string& path, const std::optional<Value>& value,
                                      int dimension, std::optional<Edit>& edit) {
  ImGui::SetNextItemWidth(-1);
  if (!value) return draw_absent(key, path, edit);
  Value shown = edit && edit->path == path && edit->value.index() == value->index() ? edit->value : *value;
  const bool changed = draw_value(key, shown, dimension);
  if (ImGui::IsItemActive()) {
    edit = {path, shown};
  } else if (edit && edit->path == path) {
    edit.reset();
  }
  if (!changed || shown == *value) return std::nullopt;
  return value_text(key, shown, dimension);
}

}  // namespace app
