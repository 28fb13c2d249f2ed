// The reference of the scene's keys, as app/scene/README.md has it.
#pragma once

#include <string>

#include "app/scene/keys.h"

namespace app {

// Markdown: a table of keys for every part of a scene. Ends with a line end.
std::string key_reference_markdown();

// What holds where the key is not given: a value as TOML, or words. `blank`: see blank_document.
std::string default_text(const Key& key, const Document& blank);

}  // namespace app
