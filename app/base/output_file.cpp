#include "app/base/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace app {
namespace {

constexpr std::size_t buffer = 1 << 16;

[[noreturn]] void throw_write_error(const std::filesystem::path& path, int error) {
  throw WriteError("cannot write " + path.string() + ": " + std::strerror(error));
}

// A renamed file is on the disk when its folder is.
void sync_folder(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // the file itself is written; a folder that may not be read is no reason to fail
  ::fsync(descriptor);
  ::close(descriptor);
}

void write_whole(const std::filesystem::path& path, std::string_view bytes, bool durable) {
  OutputFile file(path, OutputFile::Mode::create);
  file.write(bytes);
  if (durable) file.sync();
  file.close();
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path, Mode mode) : path_(std::move(path)) {
  const int how = mode == Mode::create ? O_TRUNC : O_APPEND;
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | how, 0666);
  if (descriptor_ < 0) fail();
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  try {
    close();
  } catch (const WriteError&) {  // a destructor runs here because of an earlier error, which is the one to report
    if (descriptor_ >= 0) ::close(descriptor_);
  }
}

void OutputFile::write(std::string_view bytes) {
  if (buffer_.size() + bytes.size() > buffer) flush();
  if (bytes.size() >= buffer) {
    send(bytes);
  } else {
    buffer_.append(bytes);
  }
}

void OutputFile::flush() {
  send(buffer_);
  buffer_.clear();
}

void OutputFile::sync() {
  flush();
  // EINVAL: not something that can be synced (a pipe, say), so there is nothing to wait for.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail();
}

void OutputFile::close() {
  flush();
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail();
}

void OutputFile::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::write(descriptor_, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void OutputFile::fail() const {
  throw_write_error(path_, errno);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw WriteError("cannot make the folder " + folder.string() + ": " + error.message());
  if (!std::filesystem::is_directory(folder)) {
    throw WriteError("cannot make the folder " + folder.string() + ": it is a file");
  }
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes, bool durable) {
  const std::filesystem::path temporary = path.string() + ".tmp";
  try {
    write_whole(temporary, bytes, durable);
  } catch (const WriteError&) {
    ::unlink(temporary.c_str());
    throw;
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    throw_write_error(path, error);
  }
  if (durable) sync_folder(path);
}

}  // namespace app
