#include "app/base/output_file.h"

#include <gtest/gtest.h>

#include "tests/app/temporary_folder.h"

namespace app {
namespace {

TEST(OutputFile, SmallAndLargePiecesArriveInOrder) {
  const TemporaryFolder folder;
  const std::string large(200000, 'b');
  OutputFile file(folder / "text", OutputFile::Mode::create);
  file.write("aa");
  file.write(large);
  file.write("cc");
  file.close();
  EXPECT_EQ(read_all(folder / "text"), "aa" + large + "cc");
}

TEST(OutputFile, AppendingKeepsWhatIsThere) {
  const TemporaryFolder folder;
  write_all(folder / "text", "one\n");
  OutputFile file(folder / "text", OutputFile::Mode::append);
  file.write("two\n");
  file.close();
  EXPECT_EQ(read_all(folder / "text"), "one\ntwo\n");
}

TEST(OutputFile, FullDiskIsNoticedAndTheFileNamed) {
  OutputFile file("/dev/full", OutputFile::Mode::append);
  file.write("some bytes");  // still in the buffer
  EXPECT_EQ(error_of([&] { file.flush(); }), "cannot write /dev/full: No space left on device");
}

TEST(OutputFile, FullDiskIsNoticedAtClose) {
  OutputFile file("/dev/full", OutputFile::Mode::append);
  file.write("some bytes");
  EXPECT_THROW(file.close(), WriteError);
}

TEST(OutputFile, FolderThatIsNotThereIsNamed) {
  EXPECT_EQ(error_of([] { OutputFile("/nowhere/at/all", OutputFile::Mode::create); }),
            "cannot write /nowhere/at/all: No such file or directory");
}

TEST(WriteAtomically, ReplacesAFileAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "old", true);
  write_atomically(folder / "file", "new", false);
  EXPECT_EQ(read_all(folder / "file"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder / "file.tmp"));
}

TEST(WriteAtomically, FailureKeepsTheOldFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "file" / "inside");  // a folder cannot be replaced by a file
  EXPECT_THROW(write_atomically(folder / "file", "new", true), WriteError);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "file" / "inside"));
  EXPECT_FALSE(std::filesystem::exists(folder / "file.tmp"));
}

}  // namespace
}  // namespace app
