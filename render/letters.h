// The letters that fonts are baked with: those that programs of mathematics write anyway, and those of a picture's
// words.
#pragma once

#include <imgui.h>

#include <string>

namespace render {

class Letters {
 public:
  // Latin, Greek, dashes and quotes, super- and subscripts, arrows, what formulas are written with.
  Letters();

  // Adds those of the words, in UTF-8. True when some are new.
  bool learn(const std::string& words);
  // As Dear ImGui wants them for a font; good until the next call.
  const ImWchar* ranges();

 private:
  ImFontGlyphRangesBuilder known_;
  ImVector<ImWchar> ranges_;
};

// The letters of the words, in UTF-8, that DejaVu Sans does not have, each once; empty where the font is not there.
std::string letters_that_lack(const std::string& words);

}  // namespace render
