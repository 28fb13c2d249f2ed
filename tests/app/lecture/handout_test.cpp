// The handout of the lecture, followed to the letter: each exercise is run, and its answer is in numbers.csv. The films
// of the hand show what they are for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "app/base/exit_code.h"
#include "app/command/cli.h"
#include "app/command/commands.h"
#include "app/scene/deck.h"
#include "tests/app/lecture/deck.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::istringstream text(read_all(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// The words of a command line; quotes hold words together and are left out.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool quoted = false, within = false;
  for (const char c : line) {
    if (c == '\'') {
      quoted = !quoted;
    } else if (c == ' ' && !quoted) {
      within = false;
    } else {
      if (!within) words.emplace_back();
      within = true;
      words.back() += c;
    }
  }
  return words;
}

// What a command of the documents would do, run here.
Options options_of(const std::string& command) {
  std::vector<std::string> words = words_of(command);
  words.erase(words.begin());  // build/ritz
  std::ostringstream out, err;
  int code = 0;
  const std::optional<Options> options = parse_command_line(words, out, err, code);
  if (!options) throw std::runtime_error(command + ": " + err.str());
  return *options;
}

// Rows of numbers.csv by the number of the page, from the table at the end of the handout.
std::map<std::string, std::vector<std::string>> answers() {
  static const std::regex page("^\\| ([0-9]{2}) \\|"), row("`([^`]+)`");
  std::map<std::string, std::vector<std::string>> all;
  for (const std::string& line : lines_of(lecture_deck / "README.md")) {
    std::smatch found;
    if (!std::regex_search(line, found, page)) continue;
    for (auto it = std::sregex_iterator(line.begin(), line.end(), row); it != std::sregex_iterator(); ++it)
      all[found[1]].push_back((*it)[1]);
  }
  return all;
}

TEST(Handout, EveryExerciseHasItsAnswerInNumbersCsv) {
  const std::map<std::string, std::vector<std::string>> expected = answers();
  const TemporaryFolder folder;
  std::set<std::string> exercised;
  for (const std::string& line : lines_of(lecture_deck / "README.md")) {
    const std::size_t name = line.find("-o out/exercise-");
    if (!line.starts_with("      build/ritz run ") || name == std::string::npos) continue;
    SCOPED_TRACE(line);
    const std::string page = line.substr(name + 16);
    Options options = options_of(line);
    EXPECT_TRUE(options.scene.filename().string().starts_with(page + "-"));
    options.scene = std::filesystem::path(RITZ_SOURCE_DIR) / options.scene;
    options.out = folder / page;
    options.quiet = true;
    ASSERT_EQ(run(options), exit_done);
    const std::vector<std::string> rows = lines_of(folder / page / "numbers.csv");
    ASSERT_TRUE(expected.contains(page));
    for (const std::string& answer : expected.at(page))
      EXPECT_NE(std::ranges::find(rows, answer), rows.end()) << answer;
    exercised.insert(page);
  }
  for (const std::filesystem::path& page : pages_of(lecture_deck))
    EXPECT_TRUE(exercised.contains(page.filename().string().substr(0, 2))) << page << " has no exercise";
  EXPECT_EQ(exercised.size(), expected.size());
}

// The numbers of a film by name, frame by frame.
std::map<std::string, std::vector<double>> film(const std::string& page) {
  const TemporaryFolder folder;
  Options options;
  options.scene = lecture_deck / page;
  options.replay = lecture_deck / "films" / page;
  options.out = folder / "film";
  options.quiet = true;
  options.every = 1000;
  options.width = 64;
  options.height = 36;
  EXPECT_EQ(record(options), exit_done);
  std::map<std::string, std::vector<double>> numbers;
  for (const std::string& row : lines_of(folder / "film/numbers.csv")) {
    const std::size_t a = row.find(','), b = row.find(',', a + 1);
    numbers[row.substr(a + 1, b - a - 1)].push_back(std::strtod(row.c_str() + b + 1, nullptr));
  }
  return numbers;
}

TEST(Films, ACornerIsDraggedThroughTheOtherSideAndBack) {
  auto numbers = film("09-x-ray.toml");
  const std::vector<double>& J = numbers["J"];
  ASSERT_GT(J.size(), 100U);
  EXPECT_EQ(J.front(), 1.43);
  EXPECT_LT(*std::ranges::min_element(J), -1);
  EXPECT_NEAR(J.back(), 1.43, 1e-3);
  for (const double torque : numbers["torque"]) EXPECT_LT(std::abs(torque), 1e-3);
}

TEST(Films, AStepIsDraggedThroughItsLimit) {
  auto numbers = film("11-explicit-and-implicit.toml");
  const std::vector<double>&growth = numbers["dragged.growth"], &h = numbers["dragged.h"];
  ASSERT_EQ(growth.size(), h.size());
  const double limit = 5.5731;  // ms
  for (std::size_t k = 30; k < h.size(); ++k) {
    if (h[k] < 0.99 * limit) {
      EXPECT_NEAR(growth[k], 1, 0.01) << h[k];
    } else if (h[k] > 1.02 * limit) {
      EXPECT_GT(growth[k], 1.3) << h[k];
    }
  }
  EXPECT_LT(h[30], 0.99 * limit);
  EXPECT_GT(h.back(), 1.02 * limit);
}

}  // namespace
}  // namespace app
