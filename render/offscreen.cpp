#include "render/offscreen.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace render {

std::span<const OffscreenKind> offscreen_kinds() {
  static constexpr OffscreenKind table[] = {
#ifdef RITZ_HAS_OSMESA
      {"osmesa", make_osmesa_context},
#endif
#ifdef RITZ_HAS_EGL
      {"egl", make_egl_context},
#endif
  };
  return table;
}

std::unique_ptr<Context> make_offscreen_context(std::string_view kind) {
  const auto kinds = offscreen_kinds();
  const auto found = kind.empty() ? kinds.begin() : std::ranges::find(kinds, kind, &OffscreenKind::name);
  if (found != kinds.end()) return found->make();
  std::string names;
  for (const OffscreenKind& known : kinds) names.append(names.empty() ? "" : " or ").append(known.name);
  throw std::invalid_argument("there is no context \"" + std::string(kind) +
                              "\": this program was built to draw with " + names);
}

}  // namespace render
