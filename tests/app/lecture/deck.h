// Where the pages of the lecture are.
#pragma once

#include <filesystem>

namespace app {

inline const std::filesystem::path lecture_deck = std::filesystem::path(RITZ_SOURCE_DIR) / "assets" / "lectures";

}  // namespace app
