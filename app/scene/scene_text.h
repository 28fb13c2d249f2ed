// Documents as text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/scene/document.h"

namespace app {

// The whole document with every default filled in; reading it back gives an equal document. Paths of mesh files are
// written relative to `folder`, where the text is meant to be stored.
std::string scene_toml(const Document& document, const std::filesystem::path& folder);
std::string scene_json(const Document& document, const std::filesystem::path& folder);

// A list of the document ("obstacle") as one TOML value, without the entry `left_out`.
std::string list_toml(const Document& document, std::string_view list, int left_out);

}  // namespace app
