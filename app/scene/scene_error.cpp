#include "app/scene/scene_error.h"

#include "app/scene/keys.h"
#include "sim/mesh/input_error.h"

namespace app {
namespace {

// The path itself when it was given, else the nearest table around it that was.
std::string_view known(std::string_view path, const Places& places) {
  while (!path.empty() && !places.contains(path)) path = parent(path);
  return path;
}

}  // namespace

Mistake located(const sim::InputError& error, const Places& places) {
  Indices indices = {};
  const std::string_view path = known(error.key, places);
  const auto found = places.find(path);
  const Place place = found == places.end() ? Place{} : found->second;
  // A key that was not given is still named when there is such a key.
  const std::string_view shown = find_key_at(error.key, indices) ? std::string_view(error.key) : path;
  std::string message = place.where;
  // An override is its own place: "--set time.fps=0" names key and value.
  if (!shown.empty() && place.where.find(std::string(shown) + "=") == std::string::npos) {
    message.append(message.empty() ? "" : ": ").append(shown);
    if (shown == path && !place.text.empty()) message += " = " + place.text;
  }
  return {error.key, place, message + (message.empty() ? "" : ": ") + error.what()};
}

}  // namespace app
