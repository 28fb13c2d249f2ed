#include "app/scene/basis_cache.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "app/base/output_file.h"
#include "app/base/text.h"
#include "app/base/version.h"
#include "app/scene/basis_file.h"
#include "app/scene/scene_identity.h"
#include "sim/math/checksum.h"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".basis";
constexpr std::uintmax_t most_bytes = 1'000'000'000;  // of all files together

// What decides how numbers are rounded: the program as it was built, and the processor, for which the library under
// CHOLMOD chooses its kernels.
std::string rounding() {
  const fs::path program = "/proc/self/exe";
  std::error_code none;
  std::string text = std::string(ritz_version) + ' ' + std::to_string(fs::file_size(program, none)) + ' ' +
                     std::to_string(fs::last_write_time(program, none).time_since_epoch().count());
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);)
    if (line.starts_with("model name")) return text + line;
  return text;
}

std::uint64_t key_of(const Document& document) {
  return sim::checksum(rounding(), basis_identity(document));
}

fs::path file_of(const fs::path& cache, std::uint64_t key) {
  return cache / (hexadecimal(key) + extension);
}

// The oldest files go until the others are few enough.
void tidy(const fs::path& cache) {
  struct Kept {
    fs::path path;
    fs::file_time_type used;
    std::uintmax_t bytes;
  };
  std::vector<Kept> files;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, none))
    if (entry.path().extension() == extension && entry.is_regular_file(none))
      files.push_back({entry.path(), entry.last_write_time(none), entry.file_size(none)});
  std::ranges::sort(files, std::greater(), &Kept::used);
  std::uintmax_t bytes = 0;
  for (const Kept& file : files) {
    bytes += file.bytes;
    if (bytes > most_bytes) fs::remove(file.path, none);
  }
}

}  // namespace

fs::path cache_folder() {
  // The specification takes only what is absolute.
  for (const auto& [variable, below] : {std::pair{"XDG_CACHE_HOME", ""}, std::pair{"HOME", ".cache"}})
    if (const char* folder = std::getenv(variable); folder != nullptr && fs::path(folder).is_absolute())
      return fs::path(folder) / below / "ritz";
  return {};
}

fs::path basis_file(const fs::path& cache, const Document& document) {
  return file_of(cache, key_of(document));
}

std::optional<double> take_bases(const fs::path& cache, Document& document) {
  if (cache.empty()) return std::nullopt;
  const std::uint64_t key = key_of(document);
  const fs::path path = file_of(cache, key);
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  KeptBases kept;
  try {
    kept = decode_bases(bytes, key, document.scene, path.string());
  } catch (const std::runtime_error& error) {
    document.remarks.push_back("basis: " + std::string(error.what()) + "; they are made anew");
    return std::nullopt;
  }
  for (std::size_t b = 0; b < kept.of_bodies.size(); ++b) document.scene.bodies[b].basis->vectors = kept.of_bodies[b];
  std::error_code none;  // a folder that cannot be written is no reason to fail
  fs::last_write_time(path, fs::file_time_type::clock::now(), none);
  return kept.seconds;
}

void keep_bases(const fs::path& cache, Document& document, double seconds) {
  if (cache.empty()) return;
  const std::uint64_t key = key_of(document);
  KeptBases kept{seconds, {}};
  for (const sim::Body& body : document.scene.bodies) kept.of_bodies.push_back(body.basis->vectors);
  try {
    make_folder(cache);
    write_atomically(file_of(cache, key), encode(kept, key), false);
  } catch (const WriteError& error) {
    document.remarks.push_back("basis: it is not kept for the next run: " + std::string(error.what()));
    return;
  }
  tidy(cache);
}

}  // namespace app
