#include "app/trade/case.h"

#include <algorithm>

namespace app {

std::string_view axis_name(Axis axis) {
  constexpr std::string_view names[] = {"scene", "reference", "time", "mesh", "rest", "advice"};
  return names[static_cast<int>(axis)];
}

TradeCase scene_case() {
  return {"the scene", Axis::scene, {}};
}

Options options_of(const Options& scene, const TradeCase& which) {
  Options options = scene;
  for (const auto& [key, value] : which.settings) {
    if (key == thread_option)
      options.threads = std::stoi(value);
    else
      options.overrides.push_back({key, value, key + "=" + value});
  }
  return options;
}

std::string settings_text(const TradeCase& which) {
  std::string text;
  for (const auto& [key, value] : which.settings) text += (text.empty() ? "" : ";") + key + "=" + value;
  return text;
}

TradeCase with(TradeCase which, const std::string& label, const std::string& key, const std::string& value) {
  which.label += (which.label.empty() || label.empty() ? "" : ", ") + label;
  std::erase_if(which.settings, [&](const auto& setting) { return setting.first == key; });
  which.settings.emplace_back(key, value);
  return which;
}

double Work::median() const {
  if (seconds.empty()) return 0;
  std::vector<double> sorted = seconds;
  std::ranges::sort(sorted);
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

double Work::least() const {
  return seconds.empty() ? 0 : *std::ranges::min_element(seconds);
}

}  // namespace app
