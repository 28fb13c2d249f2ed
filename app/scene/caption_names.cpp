#include "app/scene/caption_names.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

constexpr std::pair<std::string_view, CaptionValue> named_values[] = {
    {"t", CaptionValue::t},
    {"frame", CaptionValue::frame},
    {"steps", CaptionValue::steps},
    {"step", CaptionValue::step},
    {"energy", CaptionValue::energy},
    {"kinetic", CaptionValue::kinetic},
    {"elastic", CaptionValue::elastic},
    {"potential", CaptionValue::potential},
    {"iterations", CaptionValue::iterations},
    {"min_J", CaptionValue::min_J},
    {"nodes", CaptionValue::nodes},
    {"elements", CaptionValue::elements},
};

}  // namespace

std::optional<CaptionValue> find_caption_value(std::string_view name) {
  const auto* const found = std::ranges::find(named_values, name, &std::pair<std::string_view, CaptionValue>::first);
  return found == std::end(named_values) ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> known_caption_names() {
  std::vector<std::string> names;
  for (const auto& [name, value] : named_values) names.emplace_back(name);
  return names;
}

std::vector<std::string> caption_names(const std::string& text) {
  std::vector<std::string> names;
  for_each_caption_part(
      text, [](std::string_view) {}, [&](std::string_view name) { names.emplace_back(name); });
  return names;
}

void for_each_caption_part(std::string_view rest, const std::function<void(std::string_view)>& plain,
                           const std::function<void(std::string_view)>& name) {
  while (!rest.empty()) {
    const std::size_t open = rest.find('{');
    const std::size_t close = open == std::string_view::npos ? open : rest.find('}', open);
    if (close == std::string_view::npos) return plain(rest);
    plain(rest.substr(0, open));
    name(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
  }
}

}  // namespace app
