// Files that are written: every error is noticed and names the file.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace app {

// A file or folder that cannot be written; what() names it and says why.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A file open for writing, with its own buffer. All calls but the destructor throw WriteError.
class OutputFile {
 public:
  enum class Mode { create, append };  // create: an existing file is emptied

  OutputFile(std::filesystem::path path, Mode mode);
  // Closes without a word: call close() to learn whether the bytes have arrived.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  // Hands the buffer to the operating system: what is flushed survives the end of this process.
  void flush();
  // Flushes, then waits until the bytes are on the disk.
  void sync();
  void close();

 private:
  void send(std::string_view bytes);
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::string buffer_;
  int descriptor_ = -1;
};

// Makes a folder, with those around it, where it is not there. Throws WriteError.
void make_folder(const std::filesystem::path& folder);

// Replaces the file at `path`: writes a temporary name beside it and renames that, so that whoever reads, or whenever
// this process is killed, there is the old content or the new one, whole. With `durable` it survives a power cut too.
// Throws WriteError; the temporary file is then removed.
void write_atomically(const std::filesystem::path& path, std::string_view bytes, bool durable);

// The bytes of a vector as text.
inline std::string_view as_text(std::span<const unsigned char> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace app
