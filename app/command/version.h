// What `ritz --version` says.
#pragma once

#include <string>

namespace app {

// Version, commit, compiler, the contexts that draw and the instructions that are used, a line each.
std::string version_text();

}  // namespace app
