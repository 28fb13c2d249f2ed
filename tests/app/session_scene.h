// A small scene for sessions, and a session in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include "app/session/session.h"
#include "tests/app/temporary_folder.h"

namespace app {

inline constexpr const char* session_beam = R"(title = "beam"
[time]
seconds = 0.5
fps = 20
substeps = 2
[[body]]
name = "beam"
mesh = { box = [2, 1, 1], cells = [4, 2, 2], element = "tet4" }
material = { young = 1e5, poisson = 0.3, density = 1000 }
pin = [{ group = "left" }]
)";

class SessionScene : public testing::Test {
 protected:
  SessionScene() { write_all(folder_ / "beam.toml", session_beam); }

  Options options(const std::string& scene = "beam.toml") const {
    Options options;
    options.scene = folder_ / scene;
    options.width = 64;
    options.height = 48;
    options.quiet = true;
    return options;
  }
  static void take(Session& session, int steps) {
    for (int k = 0; k < steps; ++k) ASSERT_EQ(session.step().failure, "");
  }
  static std::uint64_t hash_of(const Session& session) { return sim::hash(session.state()); }

  TemporaryFolder folder_;
};

}  // namespace app
