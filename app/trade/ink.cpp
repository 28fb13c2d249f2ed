#include "app/trade/ink.h"

#include <map>

namespace app {

std::vector<std::string> inks() {
  return {black, blue, red, purple, green};
}

Ink ink_of(const std::string& integrator) {
  static const std::map<std::string, Ink> all = {
      {"backward-euler", {red, 5, 2}}, {"linearly-implicit", {purple, 9, 2}},  {"bdf2", {green, 13, 1}},
      {"trapezoidal", {blue, 6, 1}},   {"implicit-midpoint", {purple, 12, 1}}, {"sdirk2", {red, 4, 1}},
      {"tr-bdf2", {blue, 7, 1}},       {"symplectic-euler", {green, 8, 3}},    {"central-difference", {black, 11, 3}}};
  const auto found = all.find(integrator);
  return found == all.end() ? Ink{black, 1, 1} : found->second;
}

}  // namespace app
