// Folders that are read from.
#pragma once

#include <filesystem>
#include <string>

namespace app {

// Why nothing can lie in it: "there is no such folder", "is a file, not a folder"; empty where it is a folder.
inline std::string why_no_folder(const std::filesystem::path& folder) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(folder, none);
  if (std::filesystem::is_directory(status)) return "";
  return std::filesystem::exists(status) ? "is a file, not a folder" : "there is no such folder";
}

}  // namespace app
