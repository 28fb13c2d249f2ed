#include "app/command/version.h"

#include <exception>

#include "app/base/processor.h"
#include "app/base/version.h"
#include "render/gl.h"

namespace app {
namespace {

std::string contexts_text() {
  std::string text;
  for (const render::OffscreenKind& kind : render::offscreen_kinds()) {
    std::string driver;
    try {
      driver = render::driver_of(*kind.make());
    } catch (const std::exception& error) {
      driver = error.what();
    }
    text += std::string(kind.name) + ": " + driver + (text.empty() ? " (the default)" : "") + "\n              ";
  }
  return text.substr(0, text.find_last_not_of("\n ") + 1);
}

std::string instructions_text() {
  std::string text = "x86-64";
  for (const char* const* name = needed_instructions; *name != nullptr; ++name) text.append(" ").append(*name);
  return text;
}

}  // namespace

std::string version_text() {
  return "ritz " + std::string(ritz_version) + "\ncommit        " + RITZ_COMMIT + "\ncompiler      GCC " + __VERSION__ +
         "\ndraws by      " + contexts_text() + "\ninstructions  " + instructions_text();
}

}  // namespace app
