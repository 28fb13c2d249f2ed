#include "app/record/video.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/base/output_file.h"
#include "app/base/process.h"

namespace app {
namespace {

std::string rate(int fps, int every) {
  return every == 1 ? std::to_string(fps) : std::to_string(fps) + "/" + std::to_string(every);
}

// H.264 in a form that every player shows: 4:2:0 wants even sizes, so one row or column is repeated where needed.
const std::vector<std::string> mp4_arguments = {
    "-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-movflags",
    "+faststart"};

// Each picture has 256 colours of its own: a palette for all of them would need all of them in memory. Players show at
// most 50 a second; round=up keeps the first one of a video that is shorter than that.
const std::vector<std::string> gif_arguments = {
    "-filter_complex",
    "fps='min(50,source_fps)':round=up,split[a][b];[a]palettegen=stats_mode=single[p];[b][p]"
    "paletteuse=new=1:dither=bayer:bayer_scale=4"};

bool is_gif(const std::filesystem::path& file) {
  return file.extension() == ".gif";
}

const std::vector<std::string>& encoding(const std::filesystem::path& file) {
  return is_gif(file) ? gif_arguments : mp4_arguments;
}

std::vector<std::string> arguments(const std::string& file, const VideoFormat& format) {
  std::vector<std::string> list = {"ffmpeg",
                                   "-loglevel",
                                   "error",
                                   "-y",
                                   "-f",
                                   "rawvideo",
                                   "-pixel_format",
                                   "rgba",
                                   "-video_size",
                                   std::to_string(format.width) + "x" + std::to_string(format.height),
                                   "-framerate",
                                   rate(format.fps, format.every),
                                   "-i",
                                   "pipe:0"};
  list.insert(list.end(), encoding(file).begin(), encoding(file).end());
  list.push_back("file:" + file);
  return list;
}

}  // namespace

std::string video_command(const std::filesystem::path& frames, const std::filesystem::path& file, int fps, int every) {
  std::string command =
      "ffmpeg -framerate " + rate(fps, every) + " -pattern_type glob -i '" + (frames / "frame_*.png").string() + "'";
  for (const std::string& word : encoding(file)) command += word.starts_with('-') ? " " + word : " \"" + word + "\"";
  return command + " '" + file.string() + "'";
}

void require_video_name(const std::filesystem::path& file, bool overwrite) {
  const std::string option = "--video " + file.string();
  if (file.extension() != ".mp4" && !is_gif(file))
    throw std::runtime_error(option + ": the name of the video must end in .mp4 or .gif");
  if (!overwrite && std::filesystem::exists(file))
    throw std::runtime_error(option + ": exists already; choose another name or add --overwrite");
  if (std::filesystem::is_directory(file)) throw std::runtime_error(option + ": is a folder");
}

Video::Video(std::filesystem::path file, const VideoFormat& format, bool overwrite) : file_(std::move(file)) {
  require_video_name(file_, overwrite);
  if (file_.has_parent_path()) make_folder(file_.parent_path());
  start(format);
}

Video::~Video() {
  if (process_ > 0) wait_for_end();
}

void Video::start(const VideoFormat& format) {
  // A socket rather than a pipe: writing to one whose reader has gone can give an error instead of a signal.
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::runtime_error(std::string("cannot start ffmpeg: ") + std::strerror(errno));
  }
  const int error = start_process(arguments(file_.string(), format), ends[1], process_);
  ::close(ends[1]);
  if (error == 0) {
    socket_ = ends[0];
    return;
  }
  ::close(ends[0]);
  process_ = -1;
  if (error != ENOENT) throw std::runtime_error(std::string("cannot start ffmpeg: ") + std::strerror(error));
  throw std::runtime_error("--video " + file_.string() +
                           ": ffmpeg is not installed (apt-get install ffmpeg). Or record without --video, and where "
                           "there is ffmpeg, run\n  " +
                           video_command("DIR/frames", file_, format.fps, format.every));
}

void Video::write(const render::Image& image) {
  std::span<const std::uint8_t> bytes = image.rgba;
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) throw WriteError("cannot write " + file_.string() + ": ffmpeg has stopped: " + std::strerror(errno));
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
}

void Video::finish() {
  const int status = wait_for_end();
  if (status == 0) return;
  const bool exited = WIFEXITED(status);
  throw WriteError(
      "cannot write " + file_.string() + ": ffmpeg ended with " +
      (exited ? "exit code " + std::to_string(WEXITSTATUS(status)) : "signal " + std::to_string(WTERMSIG(status))));
}

int Video::wait_for_end() {
  ::close(socket_);
  return wait_for_process(std::exchange(process_, -1));
}

}  // namespace app
