#include "app/record/video.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "app/base/output_file.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

bool has_ffmpeg() {
  return std::system("ffmpeg -version > /dev/null 2>&1") == 0;
}

render::Image grey(int width, int height, std::uint8_t level) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), level)};
}

// What ffprobe says of a video: "66,42,30/1,12" = width, height, rate, frames.
std::string probe(const std::filesystem::path& file) {
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
      "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 '" +
      file.string() + "'";
  std::FILE* pipe = popen(command.c_str(), "r");
  char line[200] = "";
  const bool read = std::fgets(line, sizeof line, pipe) != nullptr;
  pclose(pipe);
  std::string text = read ? line : "";
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

// PATH without any program in it, for the time of a test.
class EmptyPath {
 public:
  EmptyPath() : before_(std::getenv("PATH")) { setenv("PATH", "/nonexistent", 1); }
  ~EmptyPath() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

TEST(Video, HasEveryPictureAtTheRightRateAndAnEvenSize) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  Video video(folder / "out.mp4", {65, 41, 60, 2}, false);
  for (int i = 0; i < 12; ++i) video.write(grey(65, 41, static_cast<std::uint8_t>(20 * i)));
  video.finish();
  EXPECT_EQ(probe(folder / "out.mp4"), "66,42,30/1,12");
}

TEST(Video, AGifHasEveryPictureButNoMoreThanPlayersShow) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  for (const auto& [fps, frames] : {std::pair{25, "12"}, {100, "6"}}) {
    const std::filesystem::path file = folder / (std::to_string(fps) + ".gif");
    Video video(file, {65, 41, fps, 1}, false);
    for (int i = 0; i < 12; ++i) video.write(grey(65, 41, static_cast<std::uint8_t>(20 * i)));
    video.finish();
    const std::string found = probe(file);
    EXPECT_TRUE(found.starts_with("65,41,")) << found;
    EXPECT_TRUE(found.ends_with(std::string(",") + frames)) << found;
  }
  {
    Video brief(folder / "brief.gif", {65, 41, 1000, 1}, false);
    for (int i = 0; i < 4; ++i) brief.write(grey(65, 41, 100));
    brief.finish();
  }
  EXPECT_TRUE(probe(folder / "brief.gif").ends_with(",1"));
}

TEST(Video, AbandonedVideoIsStillReadable) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  {
    Video video(folder / "out.mp4", {64, 48, 10, 1}, false);
    for (int i = 0; i < 3; ++i) video.write(grey(64, 48, 100));
  }
  EXPECT_EQ(probe(folder / "out.mp4"), "64,48,10/1,3");
}

TEST(Video, WithoutFfmpegThereIsACommandToRun) {
  const EmptyPath path;
  const std::string message = error_of([] { Video("out.mp4", {64, 48, 30, 1}, false); });
  EXPECT_NE(message.find("ffmpeg is not installed"), std::string::npos) << message;
  EXPECT_NE(message.find("ffmpeg -framerate 30 -pattern_type glob -i 'DIR/frames/frame_*.png'"), std::string::npos)
      << message;
}

TEST(Video, ExistingFileAndOtherEndingsAreRefused) {
  const TemporaryFolder folder;
  write_all(folder / "out.mp4", "precious");
  EXPECT_NE(error_of([&] {
              Video(folder / "out.mp4", {64, 48, 30, 1}, false);
            }).find("--overwrite"),
            std::string::npos);
  EXPECT_EQ(read_all(folder / "out.mp4"), "precious");
  std::filesystem::create_directory(folder / "folder.mp4");
  EXPECT_NE(error_of([&] {
              Video(folder / "folder.mp4", {64, 48, 30, 1}, true);
            }).find("is a folder"),
            std::string::npos);
  EXPECT_NE(error_of([&] { Video(folder / "out.txt", {64, 48, 30, 1}, true); }).find(".mp4"), std::string::npos);
}

TEST(Video, FailureOfFfmpegIsAWriteErrorNotASignal) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const auto record = [] {
    Video video("/proc/out.mp4", {640, 480, 30, 1}, false);
    for (int i = 0; i < 50; ++i) video.write(grey(640, 480, 0));
    video.finish();
  };
  EXPECT_THROW(record(), WriteError);
}

}  // namespace
}  // namespace app
