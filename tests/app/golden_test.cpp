// Two small frames against stored ones. Software rasterisers differ between processors, so not byte by byte: few pixels
// may differ by more than a shade. To store new ones after a wanted change:
//   build/ritz record assets/scenes/bear.toml --size 320x180 --seconds 0.5 --still -o /tmp/bear     (bracket alike)
//   and copy the frame to tests/data/golden/bear.png
#include <gtest/gtest.h>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "app/commands.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

struct Pixels {
  int width = 0, height = 0;
  std::unique_ptr<unsigned char, void (*)(void*)> rgb{nullptr, stbi_image_free};
};

Pixels read(const std::filesystem::path& file) {
  Pixels pixels;
  int channels = 0;
  pixels.rgb.reset(stbi_load(file.c_str(), &pixels.width, &pixels.height, &channels, 3));
  return pixels;
}

// Share of the pixels of which a channel differs by more than `shade` of 255.
double share_of_difference(const Pixels& a, const Pixels& b, int shade) {
  int count = 0;
  for (int i = 0; i < a.width * a.height; ++i) {
    int most = 0;
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.rgb.get()[3 * i + c] - b.rgb.get()[3 * i + c]));
    count += most > shade;
  }
  return static_cast<double>(count) / (a.width * a.height);
}

void compare(const std::string& scene) {
  const TemporaryFolder temporary;
  Options options;
  options.scene = std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes" / (scene + ".toml");
  options.out = temporary.path() / scene;
  options.width = 320;
  options.height = 180;
  options.still = options.quiet = true;
  options.overrides = {{"time.seconds", "0.5", "test"}};
  ASSERT_EQ(record(options), kDone);
  const Pixels drawn = read(options.out / "frames/frame_00015.png");
  const Pixels golden = read(std::filesystem::path(RITZ_SOURCE_DIR) / "tests/data/golden" / (scene + ".png"));
  ASSERT_TRUE(drawn.rgb && golden.rgb) << scene;
  ASSERT_EQ(drawn.width, golden.width);
  ASSERT_EQ(drawn.height, golden.height);
  EXPECT_LT(share_of_difference(drawn, golden, 6), 0.01) << scene;
  EXPECT_LT(share_of_difference(drawn, golden, 60), 0.001) << scene;
  // A comparison that could not fail would be none.
  const Pixels other = read(std::filesystem::path(RITZ_SOURCE_DIR) / "tests/data/golden" /
                            (scene == "bear" ? "bracket.png" : "bear.png"));
  EXPECT_GT(share_of_difference(drawn, other, 6), 0.3);
}

TEST(Golden, TheBear) {
  compare("bear");
}
TEST(Golden, TheBracket) {
  compare("bracket");
}

}  // namespace
}  // namespace app
