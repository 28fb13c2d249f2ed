// The bytes of a file.
#pragma once

#include <filesystem>
#include <string>

namespace app {

// All bytes of a regular file. Throws FileError when it is missing, is not a regular file or cannot be read.
std::string read_contents(const std::filesystem::path& path);

}  // namespace app
