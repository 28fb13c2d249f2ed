#include "app/scene/mistakes.h"

#include <algorithm>
#include <cctype>
#include <tuple>

namespace app {
namespace {

// "body.0" of "body.0.material.young", "camera" of "camera.eye".
std::string_view part_of(std::string_view path) {
  const std::size_t first = path.find('.');
  if (first == std::string_view::npos || std::isdigit(static_cast<unsigned char>(path[first + 1])) == 0) {
    return path.substr(0, first);
  }
  return path.substr(0, path.find('.', first + 1));
}

bool of_file(const Place& place, const std::string& file) {
  return place.where == file || (place.line > 0 && place.where == file + ":" + std::to_string(place.line));
}

}  // namespace

bool Mistakes::in_part_of(std::string_view path) const {
  return std::ranges::any_of(found_, [&](const Mistake& mistake) { return part_of(mistake.path) == part_of(path); });
}

void Mistakes::refuse(const std::string& path, const std::string& why) {
  const auto same_part = [&](const Mistake& other) { return part_of(other.path) == part_of(path); };
  if (std::any_of(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(earlier_), same_part)) return;
  found_.push_back(located(sim::InputError(path, why), places_));
}

SceneError Mistakes::error(const std::string& scene) const {
  std::vector<const Mistake*> sorted;
  for (const Mistake& mistake : found_) sorted.push_back(&mistake);
  std::ranges::stable_sort(sorted, {}, [&](const Mistake* mistake) {
    const Place& place = mistake->place;
    const int source = of_file(place, scene) ? 0 : place.line > 0 ? 1 : 2;
    return std::tuple(source, place.line, place.column);
  });
  std::string text;
  for (const Mistake* const mistake : sorted) text += (text.empty() ? "" : "\n") + mistake->message;
  return SceneError(text);
}

}  // namespace app
