// The documents of the repository: their links lead somewhere, and what documents and comments name exists.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/temporary_folder.h"

namespace app {
namespace {

namespace fs = std::filesystem;

const fs::path source_tree = RITZ_SOURCE_DIR;

// Every file of the repository with one of these extensions.
std::vector<fs::path> files(const std::set<std::string>& extensions) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(source_tree))
    if (entry.is_regular_file() && extensions.contains(entry.path().extension())) all.push_back(entry.path());
  for (const char* const folder : {"app", "sim", "render", "assets", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(source_tree / folder))
      if (extensions.contains(entry.path().extension())) all.push_back(entry.path());
  std::ranges::sort(all);
  return all;
}

std::string name_of(const fs::path& file) {
  return fs::relative(file, source_tree).string();
}

void for_each_match(const std::string& text, const std::regex& pattern,
                    const std::function<void(const std::smatch&)>& f) {
  for (auto it = std::sregex_iterator(text.begin(), text.end(), pattern); it != std::sregex_iterator(); ++it) f(*it);
}

// The anchor that a heading has on GitHub: lower case, blanks as dashes, without punctuation.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const unsigned char c : heading) {
    if (std::isalnum(c) || c == '-' || c == '_') anchor += static_cast<char>(std::tolower(c));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

std::set<std::string> anchors(const fs::path& document) {
  std::set<std::string> all;
  std::istringstream lines(read_all(document));
  bool code = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) code = !code;
    const std::size_t marks = line.find_first_not_of('#');
    if (!code && marks > 0 && marks != std::string::npos && line[marks] == ' ')
      all.insert(anchor_of(line.substr(marks + 1)));
  }
  return all;
}

TEST(Documents, EveryRelativeLinkLeadsSomewhere) {
  static const std::regex link(R"(\]\(([^)#\s]*)(?:#([^)\s]*))?\))");
  int links = 0;
  for (const fs::path& document : files({".md"})) {
    for_each_match(read_all(document), link, [&](const std::smatch& found) {
      const std::string path = found[1], anchor = found[2];
      if (path.find("://") != std::string::npos) return;
      const fs::path target = path.empty() ? document : document.parent_path() / path;
      EXPECT_TRUE(fs::exists(target)) << name_of(document) << " links to " << path;
      if (!anchor.empty() && fs::exists(target)) {
        EXPECT_TRUE(anchors(target).contains(anchor)) << name_of(document) << " links to " << path << "#" << anchor;
      }
      ++links;
    });
  }
  EXPECT_GT(links, 20);
}

// Paths from the top of the repository, "sim/mesh/tangle.h". What has a star or a brace stands for several.
const std::regex path_pattern(R"((?:^|[\s`"(\[])((?:app|sim|render|assets|tests)/[A-Za-z0-9_./*{}-]+))");

void expect_to_exist(const fs::path& file, const std::string& text) {
  for_each_match(text, path_pattern, [&](const std::smatch& found) {
    std::string path = found[1];
    if (path.find_first_of("*{}") != std::string::npos) return;
    while (path.ends_with('.') || path.ends_with('-')) path.pop_back();
    EXPECT_TRUE(fs::exists(source_tree / path)) << name_of(file) << " names " << path;
  });
}

TEST(Documents, EveryPathInADocumentExists) {
  for (const fs::path& document : files({".md"})) expect_to_exist(document, read_all(document));
}

TEST(Documents, EveryPathInACommentExists) {
  static const std::regex comment("//(.*)");
  for (const fs::path& source : files({".h", ".cpp"}))
    for_each_match(read_all(source), comment, [&](const std::smatch& found) { expect_to_exist(source, found[1]); });
}

// "[mathematics.md 7]", or with the end of a line of comment in between.
TEST(Documents, CommentsCiteSectionsOfTheMathematicsThatThereAre) {
  const std::string mathematics = read_all(source_tree / "sim/mathematics.md");
  static const std::regex citation(R"(mathematics\.md[\s/,]+(\d+))");
  int citations = 0;
  for (const fs::path& source : files({".h", ".cpp"})) {
    for_each_match(read_all(source), citation, [&](const std::smatch& found) {
      EXPECT_NE(mathematics.find("\n## " + found[1].str() + ". "), std::string::npos)
          << name_of(source) << " cites section " << found[1];
      ++citations;
    });
  }
  EXPECT_GE(citations, 8);
}

// What a newcomer reads in five minutes; more belongs beside what it describes.
TEST(Documents, ReadmeIsShort) {
  EXPECT_LE(std::ranges::count(read_all(source_tree / "README.md"), '\n'), 180);
}

}  // namespace
}  // namespace app
