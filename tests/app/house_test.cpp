// The walls of the house: which folder may include which. The order stands in README.md, under "The house".
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source_tree = RITZ_SOURCE_DIR;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The rooms of "app/" or "sim/" from bottom to top, as the map in README.md has them: "app/  base < options < ...".
std::vector<std::string> rooms_of(const std::string& house) {
  std::vector<std::string> rooms;
  std::istringstream readme(text_of(source_tree / "README.md"));
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("    ")) line.erase(0, 4);
    const bool begins = line.starts_with(house + "/ ") && line.find(" < ") != std::string::npos;
    const bool goes_on = inside && line.starts_with("  ") && line.find(" < ") != std::string::npos;
    inside = begins || goes_on;
    if (!inside) continue;
    std::istringstream words(begins ? line.substr(house.size() + 1) : line);
    for (std::string word; words >> word;)
      if (word != "<") rooms.push_back(word);
  }
  return rooms;
}

// "sim/mesh/check.cpp" is in the room "mesh", the file "sim/state.cpp" in the room "state.h".
std::string room_of(const std::string& path) {
  const std::size_t first = path.find('/') + 1, second = path.find('/', first);
  const std::string room = path.substr(first, second == std::string::npos ? second : second - first);
  if (second != std::string::npos || !room.ends_with(".cpp") || room == "main.cpp") return room;
  return room.substr(0, room.size() - 4) + ".h";
}

std::vector<std::string> includes_of(const fs::path& file) {
  static const std::regex include("#include \"((?:app|sim|render)/[^\"]+)\"");
  const std::string text = text_of(file);
  std::vector<std::string> all;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it)
    all.push_back((*it)[1]);
  return all;
}

template <class F>
void for_each_source(const std::string& house, const F& f) {
  for (const auto& entry : fs::recursive_directory_iterator(source_tree / house)) {
    const std::string extension = entry.path().extension();
    if (extension == ".cpp" || extension == ".h") f(fs::relative(entry.path(), source_tree).string(), entry.path());
  }
}

TEST(House, EachRoomIncludesOnlyThoseBeforeIt) {
  for (const std::string house : {"sim", "app"}) {
    std::map<std::string, int> floor;
    for (const std::string& room : rooms_of(house)) floor.emplace(room, static_cast<int>(floor.size()));
    ASSERT_GT(floor.size(), 10u) << "README.md says the order of " << house;
    for_each_source(house, [&](const std::string& name, const fs::path& file) {
      const std::string room = room_of(name);
      ASSERT_TRUE(floor.contains(room)) << name << ": no such room in README.md";
      for (const std::string& included : includes_of(file)) {
        if (!included.starts_with(house + "/")) continue;
        EXPECT_LE(floor[room_of(included)], floor[room]) << name << " includes " << included << ", which is above it";
      }
    });
  }
}

TEST(House, RenderKnowsNeitherSimNorApp) {
  for_each_source("render", [](const std::string& name, const fs::path& file) {
    for (const std::string& included : includes_of(file))
      EXPECT_TRUE(included.starts_with("render/")) << name << " includes " << included;
  });
}

TEST(House, SimKnowsNeitherRenderNorApp) {
  for_each_source("sim", [](const std::string& name, const fs::path& file) {
    for (const std::string& included : includes_of(file))
      EXPECT_TRUE(included.starts_with("sim/")) << name << " includes " << included;
  });
}

// Names that a source file defines for itself alone, in "namespace {" at the beginning of a line.
std::set<std::string> own_names(const fs::path& file) {
  static const std::regex definition(
      R"(^(?:struct|class|enum class) (\w+)|^(?!return|template|using|#|//)[\w\[].*?[\s&*>](\w+)\()");
  std::set<std::string> names;
  std::istringstream text(text_of(file));
  bool own = false;
  for (std::string line; std::getline(text, line);) {
    if (line == "namespace {") own = true;
    if (line == "}  // namespace") own = false;
    std::smatch found;
    if (own && std::regex_search(line, found, definition)) names.insert(found[1].matched ? found[1] : found[2]);
  }
  return names;
}

// Files of a folder are compiled together: a function of one must not serve as an overload in another.
TEST(House, FilesOfAFolderShareNoNamesOfTheirOwn) {
  for (const std::string house : {"sim", "render", "app"}) {
    std::map<std::pair<fs::path, std::string>, std::string> owner;
    for_each_source(house, [&](const std::string& name, const fs::path& file) {
      if (file.extension() != ".cpp") return;
      for (const std::string& own : own_names(file)) {
        if (own == "main") continue;  // of shaders
        const auto [entry, is_new] = owner.insert({{file.parent_path(), own}, name});
        EXPECT_TRUE(is_new) << own << " is in " << name << " and in " << entry->second;
      }
    });
    EXPECT_GT(owner.size(), 50u) << house;
  }
}

TEST(House, TheTopLevelHasNoOtherEntries) {
  const std::vector<std::string> allowed = {"app", "sim", "render", "assets", "tests", "CMakeLists.txt", "README.md"};
  for (const auto& entry : fs::directory_iterator(source_tree)) {
    const std::string name = entry.path().filename();
    if (name.starts_with(".") || name.starts_with("build") || name == "out") continue;
    EXPECT_NE(std::ranges::find(allowed, name), allowed.end()) << name;
  }
}

}  // namespace
