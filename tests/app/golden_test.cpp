// A small frame of every look against a stored one, by the command that a CI uses. To store new ones after a wanted
// change, and to look at them:
//   RITZ_STORE_GOLDEN=1 build/app_tests --gtest_filter='Golden/*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <tuple>

#include "app/base/exit_code.h"
#include "app/base/output_file.h"
#include "app/command/commands.h"
#include "render/compare.h"
#include "render/context.h"
#include "render/png.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

namespace fs = std::filesystem;

struct Golden {
  const char* name;
  const char* scene;  // below the source folder
  const char* seconds;
  std::vector<std::pair<const char*, const char*>> keys;
};

const std::vector<Golden>& looks() {
  static const std::vector<Golden> all = {
      {"bear", "assets/scenes/bear.toml", "0.5", {}},
      {"rubber", "assets/scenes/bear.toml", "0.5", {{"look.finish", "\"rubber\""}, {"camera.orbit", "60"}}},
      {"flat-faces",
       "assets/scenes/bear.toml",
       "0.1",
       {{"look.smooth", "false"}, {"look.wireframe", "true"}, {"look.shadows", "false"}}},
      {"bracket", "assets/scenes/bracket.toml", "0.5", {}},
      {"figure",
       "assets/scenes/bracket.toml",
       "0.5",
       {{"look.axes", "true"},
        {"look.scale_bar", "true"},
        {"look.ghost", "true"},
        {"look.pins", "true"},
        {"look.colour", "\"stretch\""},
        {"look.range", "[0.9, 1.1]"},
        {"look.wireframe", "false"}}},
      {"energies", "assets/scenes/beam.toml", "0.4", {{"look.energies", "true"}, {"look.colour_map", "\"cividis\""}}},
      {"arrows",
       "assets/scenes/beam.toml",
       "0.4",
       {{"look.forces", "true"},
        {"look.velocities", "true"},
        {"look.pins", "true"},
        {"look.ghost", "true"},
        {"look.colour", "\"plain\""}}},
      {"fall", "tests/data/looks/fall.toml", "0.6", {}},
      {"paper",
       "tests/data/looks/fall.toml",
       "0.3",
       {{"look.background", "\"paper\""},
        {"look.colour", "\"J\""},
        {"look.labels", "false"},
        {"look.obstacles", "false"}}},
      {"contact", "assets/scenes/arch.toml", "0.3", {{"look.contact_forces", "true"}, {"look.colour", "\"plain\""}}},
      {"drop", "assets/scenes/two-boxes.toml", "0.4", {}},
  };
  return all;
}

Options options_for(const Golden& golden, const fs::path& out) {
  Options options;
  options.scene = fs::path(RITZ_SOURCE_DIR) / golden.scene;
  options.out = out;
  options.width = 320;
  options.height = 180;
  options.still = options.quiet = true;
  options.overrides = {{"time.seconds", golden.seconds, "test"}};
  for (const auto& [key, value] : golden.keys) options.overrides.push_back({key, value, "test"});
  return options;
}

fs::path stored(const Golden& golden) {
  return fs::path(RITZ_SOURCE_DIR) / "tests/data/golden" / golden.name;
}

std::vector<std::string> context_names() {
  std::vector<std::string> names;
  for (const render::OffscreenKind& kind : render::offscreen_kinds()) names.emplace_back(kind.name);
  return names;
}

bool store() {
  return std::getenv("RITZ_STORE_GOLDEN") != nullptr;
}

// Every look by everything that draws here.
class GoldenLook : public testing::TestWithParam<std::tuple<std::string, std::size_t>> {};

TEST_P(GoldenLook, IsDrawnAsStored) {
  const auto& [context, look] = GetParam();
  const Golden& golden = looks()[look];
  const TemporaryFolder temporary;
  Options options = options_for(golden, temporary / "run");
  options.context = context;
  if (store()) {
    if (context != context_names().front()) GTEST_SKIP() << "the first one stores";
    ASSERT_EQ(record(options), exit_done);
    fs::remove_all(stored(golden));
    fs::copy(temporary / "run/frames", stored(golden), fs::copy_options::recursive);
    GTEST_SKIP() << "stored in " << stored(golden);
  }
  options.expect = stored(golden);
  options.expect_share = 0.01;  // software rasterisers differ between processors
  EXPECT_EQ(record(options), exit_done) << golden.name;
  const std::string json = read_all(temporary / "run/run.json");
  EXPECT_NE(json.find("\"context\": \"" + context + "\""), std::string::npos) << json;
}

INSTANTIATE_TEST_SUITE_P(Golden, GoldenLook,
                         testing::Combine(testing::ValuesIn(context_names()),
                                          testing::Range(std::size_t{0}, looks().size())),
                         [](const auto& info) {
                           std::string name = std::get<0>(info.param) + "_" + looks()[std::get<1>(info.param)].name;
                           std::erase(name, '-');
                           return name;
                         });

render::Image picture_of(const Golden& golden) {
  for (const fs::directory_entry& entry : fs::directory_iterator(stored(golden))) {
    return render::decode_png(read_all(entry.path()));
  }
  return {};
}

// A comparison that could not fail would be none: no look passes for another.
TEST(Golden, LooksDifferFromEachOther) {
  if (store()) GTEST_SKIP();
  for (std::size_t i = 0; i < looks().size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double share = render::compare(picture_of(looks()[i]), picture_of(looks()[k]), 8).share;
      EXPECT_GT(share, 0.02) << looks()[i].name << " and " << looks()[k].name;
    }
  }
}

}  // namespace
}  // namespace app
