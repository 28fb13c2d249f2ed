#include "app/mesh/contents.h"

#include <cerrno>
#include <fstream>
#include <new>
#include <system_error>

#include "app/mesh/error.h"

namespace app {

std::string read_contents(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw FileError(path.string() + ": no such file");
  if (!std::filesystem::is_regular_file(status)) throw FileError(path.string() + ": not a file that can be read");
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream in(path, std::ios::binary);
  if (error || !in) {
    throw FileError(path.string() + ": cannot be opened: " +
                    (error ? error : std::error_code(errno, std::generic_category())).message());
  }
  std::string content;
  try {
    content.resize(size);
  } catch (const std::exception&) {
    throw FileError(path.string() + ": " + std::to_string(size) + " bytes do not fit into memory");
  }
  in.read(content.data(), static_cast<std::streamsize>(size));
  if (in.gcount() != static_cast<std::streamsize>(size)) {
    throw FileError(path.string() + ": only " + std::to_string(in.gcount()) + " of " + std::to_string(size) +
                    " bytes could be read");
  }
  return content;
}

}  // namespace app
