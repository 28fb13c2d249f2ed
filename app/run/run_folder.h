// The folder that a run leaves: which files it has, and that nothing in it is lost by mistake.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace app {

enum class Existing {
  refuse,     // a folder that holds a run is left alone
  overwrite,  // the files of the earlier run may be removed
  resume,     // they stay: the run goes on
};

class RunFolder {
 public:
  // Touches nothing yet. Throws std::runtime_error when the folder holds a run and `existing` is refuse, when it has no
  // state.bin and `existing` is resume.
  RunFolder(std::filesystem::path folder, Existing existing);

  // Removes the files of an earlier run in it, and nothing else. Throws WriteError.
  void clear() const;

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path run_json() const { return folder_ / "run.json"; }
  std::filesystem::path scene() const { return folder_ / "run.toml"; }
  std::filesystem::path session() const { return folder_ / "session.toml"; }  // that was replayed
  std::filesystem::path probes() const { return folder_ / "probes.csv"; }
  std::filesystem::path steps() const { return folder_ / "steps.csv"; }
  std::filesystem::path contacts() const { return folder_ / "contacts.csv"; }
  std::filesystem::path numbers() const { return folder_ / "numbers.csv"; }
  std::filesystem::path curves() const { return folder_ / "curves.csv"; }
  std::filesystem::path state() const { return folder_ / "state.bin"; }
  std::filesystem::path frames() const { return folder_ / "frames"; }
  std::filesystem::path vtu_folder() const { return folder_ / "vtu"; }
  std::filesystem::path differences() const { return folder_ / "differences"; }
  std::filesystem::path difference(std::int64_t number) const { return differences() / frame_name(number); }
  std::filesystem::path expect_table() const { return folder_ / "expect.csv"; }
  std::filesystem::path pvd() const { return folder_ / "run.pvd"; }
  std::filesystem::path frame(std::int64_t number) const { return frames() / frame_name(number); }
  std::filesystem::path vtu(std::int64_t number) const { return vtu_folder() / vtu_name(number); }
  static std::string frame_name(std::int64_t number) { return numbered("frame_", number, ".png"); }
  static std::string vtu_name(std::int64_t number) { return numbered("frame_", number, ".vtu"); }

 private:
  static std::string numbered(const std::string& start, std::int64_t number, const std::string& end);
  // The files of an earlier run in it, in the order of their names.
  std::vector<std::filesystem::path> files_of_a_run() const;

  std::filesystem::path folder_;
};

}  // namespace app
