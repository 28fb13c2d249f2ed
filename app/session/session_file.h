// session.toml, read: what was done in a session, to be done again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/options/options.h"
#include "app/session/input.h"

namespace app {

struct SessionFile {
  struct Entry {
    Event event;
    std::string place;  // "session.toml:12"
  };
  std::filesystem::path settings;   // as they were given to `ritz view`
  std::vector<Override> overrides;  // --set, --seconds, --fps
  std::vector<Entry> inputs;        // in the order of their steps
  std::int64_t steps = 0;           // taken in all; without [end], up to the last input
  std::string state_hash;           // at the end; empty without [end]
};

// Throws SceneError, "FILE:LINE: ...", for what is no session.
SessionFile read_session(const std::filesystem::path& path);

}  // namespace app
