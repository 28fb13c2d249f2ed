#include "app/session/effect.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

bool under(std::string_view path, std::string_view table) {
  return path.starts_with(table) && (path.size() == table.size() || path[table.size()] == '.');
}

}  // namespace

Effect effect_of(const Key& key) {
  const auto in = [&](const auto& tables) {
    return std::ranges::any_of(tables, [&](std::string_view table) { return under(key.path, table); });
  };
  // The frames' times and the numbering of nodes and elements; names, by which keys refer to each other.
  constexpr std::array<std::string_view, 4> at_restart = {"time.fps", "body[].mesh", "body[].name",
                                                          "body[].region[].group"};
  if (in(std::array<std::string_view, 4>{"title", "camera", "look", "time.seconds"})) return Effect::look;
  if (in(std::array<std::string_view, 2>{"body[].velocity", "body[].spin"})) return Effect::start;
  return in(at_restart) || key.kind == Kind::list ? Effect::restart : Effect::motion;
}

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

}  // namespace app
