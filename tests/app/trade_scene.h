// A small smooth scene for `ritz trade`, and its table read back.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "app/command/commands.h"
#include "tests/app/temporary_folder.h"

namespace app {

// A plate in the plane, pulled upwards by a load that rises smoothly.
inline constexpr const char* plate_scene = R"(
title = "plate"
[time]
seconds = 0.4
fps = 30
substeps = 3
integrator = "sdirk2"
[solver]
tolerance = 1e-6
[world]
gravity = [0, 0]
[[body]]
name = "plate"
mesh = { rectangle = [2, 1], cells = [4, 2] }
material = { young = 2e4, poisson = 0.3 }
pin = [{ group = "left" }]
traction = [{ group = "right", value = [0, 1000], ramp = 0.4 }]
)";

class TradeTest : public testing::Test {
 protected:
  Options options(const char* text = plate_scene) const {
    write_all(folder_ / "plate.toml", text);
    Options options;
    options.scene = folder_ / "plate.toml";
    options.out = folder_ / "trade";
    options.quiet = true;
    return options;
  }
  // Rows of trade.csv by case: column name to cell.
  std::map<std::string, std::map<std::string, std::string>> rows(const std::filesystem::path& folder) const {
    std::istringstream text(read_all(folder / "trade.csv"));
    std::map<std::string, std::map<std::string, std::string>> all;
    std::vector<std::string> names;
    for (std::string line; std::getline(text, line);) {
      const std::vector<std::string> cells = split(line);
      if (names.empty()) {
        names = cells;
        continue;
      }
      EXPECT_EQ(cells.size(), names.size()) << line;
      for (std::size_t k = 0; k < cells.size(); ++k) all[cells[0]][names[k]] = cells[k];
    }
    return all;
  }
  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        cells.emplace_back();
      else
        cells.back() += c;
    }
    return cells;
  }

  TemporaryFolder folder_;
};

}  // namespace app
