// One input of the fuzzer for session.toml, and what must hold for whatever it is: a session whose inputs can be
// written and read again as the same, or a SceneError.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/base/output_file.h"
#include "app/scene/scene_error.h"
#include "app/session/session_file.h"
#include "app/session/session_log.h"

namespace app {

inline std::string text_of(const SessionFile& session) {
  std::string text = "scene = \"a scene\"\n";
  for (const SessionFile::Entry& entry : session.inputs) text += event_text(entry.event, 3);
  return text;
}

// True when a session was read, false when the input was refused. `file`: a name to write the input to.
inline bool try_session_input(std::string_view input, const std::filesystem::path& file) {
  try {
    write_atomically(file, input, false);
    const SessionFile session = read_session(file);
    const std::string text = text_of(session);
    write_atomically(file, text, false);
    if (text_of(read_session(file)) != text) std::abort();
    return true;
  } catch (const SceneError&) {
    return false;
  }
}

}  // namespace app
