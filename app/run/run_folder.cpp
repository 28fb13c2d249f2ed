#include "app/run/run_folder.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "app/base/folder.h"
#include "app/base/output_file.h"
#include "app/base/text.h"

namespace app {
namespace {

namespace fs = std::filesystem;

bool is_numbered(const std::string& name) {
  return name.starts_with("frame_") && (name.ends_with(".png") || name.ends_with(".vtu") || name.ends_with(".tmp"));
}

}  // namespace

RunFolder::RunFolder(fs::path folder, Existing existing) : folder_(std::move(folder)) {
  if (existing == Existing::resume) {
    if (fs::exists(state())) return;
    const std::string why = why_no_folder(folder_);
    throw std::runtime_error(folder_.string() + ": " + (why.empty() ? "holds no state.bin" : why) +
                             ", so there is nothing to resume");
  }
  if (existing == Existing::overwrite) return;
  const std::vector<fs::path> earlier = files_of_a_run();
  if (earlier.empty()) return;
  throw std::runtime_error(folder_.string() + ": holds a run already (" + earlier.front().string() +
                           "); choose another folder with -o, replace it with --overwrite, or go on with --resume " +
                           folder_.string());
}

void RunFolder::clear() const {
  for (const fs::path& file : files_of_a_run()) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw WriteError("cannot replace " + file.string() + ": " + error.message());
  }
}

std::string RunFolder::numbered(const std::string& start, std::int64_t number, const std::string& end) {
  return start + formatted("%05lld", static_cast<long long>(number)) + end;
}

std::vector<fs::path> RunFolder::files_of_a_run() const {
  std::vector<fs::path> found;
  for (const fs::path& file : {run_json(), scene(), session(), probes(), steps(), contacts(), numbers(), curves(),
                               state(), pvd(), expect_table()}) {
    if (fs::exists(file)) found.push_back(file);
  }
  for (const fs::path& folder : {frames(), vtu_folder(), differences()}) {
    if (!fs::is_directory(folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (is_numbered(entry.path().filename().string())) found.push_back(entry.path());
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace app
