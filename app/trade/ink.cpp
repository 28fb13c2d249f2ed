#include "app/trade/ink.h"

#include <algorithm>
#include <iterator>

namespace app {

Ink ink_of(std::string_view integrator) {
  const auto* const found = std::ranges::find(scheme_inks, integrator, &SchemeInk::integrator);
  return found == std::end(scheme_inks) ? setting_ink : found->ink;
}

std::vector<std::string> dark_colours() {
  std::vector<std::string> all = {black, blue, red};
  for (const SchemeInk& scheme : scheme_inks) all.emplace_back(scheme.ink.dark);
  return all;
}

}  // namespace app
