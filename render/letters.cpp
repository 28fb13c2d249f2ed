#include "render/letters.h"

#include <array>

#include "render/imgui_setup.h"

namespace render {
namespace {

constexpr std::array<ImWchar, 27> usual_letters = {
    0x20,   0xff,   0x2b0,  0x2b8,  0x370,  0x3ff,  0x1d2c, 0x1d6a, 0x1e8a, 0x1e8d, 0x2010, 0x203a, 0x2070, 0x209c,
    0x2190, 0x2193, 0x21d2, 0x21d4, 0x2200, 0x222b, 0x2248, 0x2248, 0x2260, 0x2265, 0x2c7c, 0x2c7c, 0};
constexpr float any_size = 16;  // pixels

// The bytes of the letter that starts at `at` in UTF-8.
std::size_t length_at(const std::string& words, std::size_t at) {
  std::size_t length = 1;
  while (at + length < words.size() && (static_cast<unsigned char>(words[at + length]) & 0xC0U) == 0x80U) ++length;
  return length;
}

// Dear ImGui knows letters of 16 bits: others become none of them. 0 for what stands for no letter (a line end).
unsigned letter_at(const std::string& words, std::size_t at, std::size_t length) {
  ImFontGlyphRangesBuilder one;
  one.AddText(words.data() + at, words.data() + at + length);
  ImVector<ImWchar> range;
  one.BuildRanges(&range);
  return length > 3 ? 0xFFFFU : range.empty() ? 0U : range[0];
}

// Dear ImGui keeps a font at each of its sizes since 1.92, and asks the file what it has.
bool has_letter(ImFont& font, ImWchar letter) {
#if IMGUI_VERSION_NUM >= 19200
  return font.IsGlyphInFont(letter);
#else
  return font.FindGlyphNoFallback(letter) != nullptr;
#endif
}

}  // namespace

Letters::Letters() {
  known_.AddRanges(usual_letters.data());
}

bool Letters::learn(const std::string& words) {
  ImFontGlyphRangesBuilder own;
  own.AddText(words.data(), words.data() + words.size());
  bool is_new = false;
  for (int i = 0; i < own.UsedChars.size(); ++i) {
    is_new = is_new || (own.UsedChars[i] & ~known_.UsedChars[i]) != 0;
    known_.UsedChars[i] |= own.UsedChars[i];
  }
  return is_new;
}

const ImWchar* Letters::ranges() {
  ranges_.clear();
  known_.BuildRanges(&ranges_);
  return ranges_.Data;
}

std::string letters_that_lack(const std::string& words) {
  Letters letters;
  if (!letters.learn(words)) return {};
  ImFontAtlas atlas;
  ImFont* font = load_font(atlas, "DejaVuSans.ttf", any_size, letters.ranges());
  if (!has_dejavu() || !atlas.Build()) return {};
  std::string lacking;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t length = length_at(words, at);
    const std::string letter = words.substr(at, length);
    const unsigned code = letter_at(words, at, length);
    at += length;
    if (code < 0x20 || lacking.find(letter) != std::string::npos) continue;
    if (!has_letter(*font, static_cast<ImWchar>(code))) lacking += letter;
  }
  return lacking;
}

}  // namespace render
