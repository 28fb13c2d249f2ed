#include <algorithm>

#include "app/trade/chart_layout.h"

namespace app {
namespace {

// Of the height of letters, of a sans serif face, rounded up.
double letter_width(char letter) {
  constexpr std::string_view narrow = " ijlft/.,:;'|!()[]-", wide = "mwMW%";
  if (narrow.find(letter) != std::string_view::npos) return 0.4;
  if (wide.find(letter) != std::string_view::npos) return 0.98;
  return letter >= 'A' && letter <= 'Z' ? 0.72 : 0.64;
}

}  // namespace

double text_width(std::string_view text, bool large) {
  double width = 0;
  for (const char letter : text) width += letter_width(letter);
  return width * (large ? large_letters : small_letters);
}

std::string fitting(const std::string& text, bool large, double width) {
  if (text_width(text, large) <= width) return text;
  std::string shorter = text;
  while (!shorter.empty() && text_width(shorter + "...", large) > width) shorter.pop_back();
  return shorter + "...";
}

}  // namespace app
