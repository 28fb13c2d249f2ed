#include "app/run/run_folder.h"

#include <gtest/gtest.h>

#include "app/base/output_file.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

TEST(RunFolder, IsMadeWithItsParents) {
  const TemporaryFolder temporary;
  const RunFolder folder(temporary / "out" / "bear", Existing::refuse);
  EXPECT_FALSE(std::filesystem::exists(temporary / "out"));  // a run that cannot begin leaves nothing
  make_folder(folder.path());
  EXPECT_TRUE(std::filesystem::is_directory(temporary / "out" / "bear"));
  EXPECT_EQ(folder.frame(7), temporary / "out" / "bear" / "frames" / "frame_00007.png");
  EXPECT_EQ(folder.frame(123456).filename(), "frame_123456.png");
}

TEST(RunFolder, NeitherFramesNorNumbersAreOverwrittenUnasked) {
  for (const char* name : {"frames/frame_00003.png", "run.json", "steps.csv", "probes.csv", "state.bin", "run.pvd"}) {
    const TemporaryFolder temporary;
    write_all(temporary / name, "precious");
    const std::string message = error_of([&] { RunFolder(temporary.path(), Existing::refuse); });
    EXPECT_NE(message.find("holds a run already"), std::string::npos) << name;
    EXPECT_NE(message.find("--overwrite"), std::string::npos) << name;
    EXPECT_EQ(read_all(temporary / name), "precious");
  }
}

TEST(RunFolder, FilesOfOthersAreNoRun) {
  const TemporaryFolder temporary;
  write_all(temporary / "notes.txt", "mine");
  write_all(temporary / "frames" / "photo.png", "mine too");
  EXPECT_EQ(error_of([&] { RunFolder(temporary.path(), Existing::refuse); }), "");
}

TEST(RunFolder, ClearRemovesTheFilesOfARunAndNothingElse) {
  const TemporaryFolder temporary;
  for (const char* name : {"frames/frame_00000.png", "frames/frame_00099.png", "vtu/frame_00000.vtu", "run.json"}) {
    write_all(temporary / name, "old");
  }
  for (const char* name : {"frames/photo.png", "notes.txt", "frame_00001.png"}) write_all(temporary / name, "mine");
  const RunFolder folder(temporary.path(), Existing::overwrite);
  EXPECT_TRUE(std::filesystem::exists(temporary / "run.json"));  // opening alone removes nothing
  folder.clear();
  EXPECT_FALSE(std::filesystem::exists(temporary / "frames/frame_00099.png"));
  EXPECT_FALSE(std::filesystem::exists(temporary / "vtu/frame_00000.vtu"));
  EXPECT_FALSE(std::filesystem::exists(temporary / "run.json"));
  for (const char* name : {"frames/photo.png", "notes.txt", "frame_00001.png"}) {
    EXPECT_EQ(read_all(temporary / name), "mine") << name;
  }
}

TEST(RunFolder, ResumingNeedsAState) {
  const TemporaryFolder temporary;
  EXPECT_NE(error_of([&] { RunFolder(temporary.path(), Existing::resume); }).find("nothing to resume"),
            std::string::npos);
  write_all(temporary / "state.bin", "state");
  write_all(temporary / "frames" / "frame_00000.png", "kept");
  EXPECT_EQ(error_of([&] { RunFolder(temporary.path(), Existing::resume); }), "");
  EXPECT_EQ(read_all(temporary / "frames" / "frame_00000.png"), "kept");
}

TEST(RunFolder, AFileInTheWayIsNamed) {
  const TemporaryFolder temporary;
  write_all(temporary / "out", "a file");
  for (const std::filesystem::path& path : {temporary / "out", temporary / "out" / "deeper"}) {
    const RunFolder folder(path, Existing::refuse);
    EXPECT_THROW(make_folder(path), WriteError);
  }
}

}  // namespace
}  // namespace app
