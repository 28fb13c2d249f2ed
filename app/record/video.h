// A video file, made by ffmpeg from raw pictures that are piped to it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "render/image.h"

namespace app {

struct VideoFormat {
  int width = 0, height = 0;  // pixels of each picture
  int fps = 60;               // pictures per second ...
  int every = 1;              // ... over this
};

// Throws std::runtime_error when the file's name does not end in .mp4 or .gif, and when it exists and may not be
// overwritten.
void require_video_name(const std::filesystem::path& file, bool overwrite);

class Video {
 public:
  // Starts ffmpeg. Throws std::runtime_error when it is not installed (with the command to run by hand), and as above.
  Video(std::filesystem::path file, const VideoFormat& format, bool overwrite);
  // Ends the video where it is, without a word: call finish() to learn whether it is whole.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  // Throws WriteError when ffmpeg has stopped (its own words are on stderr).
  void write(const render::Image& image);
  // Waits until ffmpeg has written everything. Throws WriteError when it reports an error.
  void finish();

 private:
  void start(const VideoFormat& format);
  int wait_for_end();

  std::filesystem::path file_;
  int socket_ = -1;
  pid_t process_ = -1;
};

// What to type to make the video from frames that were recorded as PNG files.
std::string video_command(const std::filesystem::path& frames, const std::filesystem::path& file, int fps, int every);

}  // namespace app
