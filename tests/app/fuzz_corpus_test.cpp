// What the fuzzers of scene files, saved states and sessions were given and found stays harmless.
#include <gtest/gtest.h>

#include "tests/app/mesh_data.h"
#include "tests/app/temporary_folder.h"
#include "tests/fuzz/scene_input.h"
#include "tests/fuzz/session_input.h"
#include "tests/fuzz/state_input.h"

namespace app {
namespace {

template <class Try>
int replay(const char* corpus, const Try& attempt) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / corpus)) {
    SCOPED_TRACE(entry.path());
    attempt(read_all(entry.path()));
    ++count;
  }
  return count;
}

TEST(FuzzCorpus, ScenesAreReadOrRefused) {
  const TemporaryFolder folder;
  int read = 0;
  EXPECT_GT(replay("fuzz-scene", [&](const std::string& input) { read += try_scene_input(input, folder / "a.toml"); }),
            20);
  EXPECT_GT(read, 5);
}

TEST(FuzzCorpus, StatesAreReadOrRefused) {
  int read = 0;
  EXPECT_GT(replay("fuzz-state", [&](const std::string& input) { read += try_state_input(input); }), 5);
  EXPECT_GT(read, 1);
}

TEST(FuzzCorpus, SessionsAreReadOrRefused) {
  const TemporaryFolder folder;
  int read = 0;
  EXPECT_GT(
      replay("fuzz-session", [&](const std::string& input) { read += try_session_input(input, folder / "a.toml"); }),
      5);
  EXPECT_GT(read, 3);
}

}  // namespace
}  // namespace app
