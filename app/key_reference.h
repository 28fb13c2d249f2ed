// The reference of the scene's keys, as README.md has it.
#pragma once

#include <string>

namespace app {

// Markdown: a table of keys for every part of a scene. Ends with a line end.
std::string key_reference_markdown();

}  // namespace app
