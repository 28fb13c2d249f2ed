#include "render/compare.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "render/png.h"

namespace {

render::Image grey(int width, int height, std::uint8_t level) {
  render::Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), level)};
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

TEST(Compare, CountsPixelsBeyondTheToleratedDifference) {
  const render::Image one = grey(10, 10, 100);
  render::Image other = one;
  other.rgba[0] = 104;
  other.rgba[4 * 7 + 2] = 70;
  other.rgba[4 * 9 + 1] = 109;
  EXPECT_EQ(render::compare(one, one, 0).largest, 0);
  EXPECT_EQ(render::compare(one, one, 0).share, 0);
  EXPECT_EQ(render::compare(one, other, 0).largest, 30);
  EXPECT_DOUBLE_EQ(render::compare(one, other, 0).share, 0.03);
  EXPECT_DOUBLE_EQ(render::compare(one, other, 4).share, 0.02);
  EXPECT_DOUBLE_EQ(render::compare(one, other, 9).share, 0.01);
  EXPECT_DOUBLE_EQ(render::compare(one, other, 30).share, 0);
}

TEST(Compare, ThePictureShowsWhere) {
  const render::Image one = grey(4, 1, 100);
  render::Image other = one;
  other.rgba[4] = 105;
  other.rgba[8] = 200;
  const render::Image picture = render::difference_picture(one, other, 8);
  const auto red = [&](int x) { return picture.rgba[4 * x]; };
  const auto blue = [&](int x) { return picture.rgba[4 * x + 2]; };
  EXPECT_EQ(red(0), blue(0));  // the same: grey
  EXPECT_GT(red(1), 200);      // tolerated: yellow
  EXPECT_GT(picture.rgba[5], 180);
  EXPECT_GT(red(2), 150);  // beyond: red
  EXPECT_LT(picture.rgba[9], 60);
}

TEST(Compare, OtherSizesAreRefused) {
  EXPECT_THROW(render::compare(grey(4, 4, 0), grey(4, 5, 0), 0), std::invalid_argument);
  EXPECT_THROW(render::difference_picture(grey(4, 4, 0), grey(2, 8, 0), 0), std::invalid_argument);
}

TEST(DecodePng, ReadsWhatWasEncodedAndRefusesTheRest) {
  render::Image image = grey(13, 7, 30);
  image.rgba[20] = 250;
  const std::vector<std::uint8_t> bytes = render::encode_png(image);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const render::Image read = render::decode_png(text);
  EXPECT_EQ(read.width, 13);
  EXPECT_EQ(read.height, 7);
  EXPECT_EQ(read.rgba, image.rgba);
  EXPECT_THROW(render::decode_png(text.substr(0, 40)), std::invalid_argument);
  EXPECT_THROW(render::decode_png("no picture"), std::invalid_argument);
  EXPECT_THROW(render::decode_png(""), std::invalid_argument);
}

}  // namespace
