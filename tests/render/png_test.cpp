#include "render/png.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <thread>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace {

// Half smooth, half noise, so that every kind of deflate block occurs.
render::Image test_image(int width, int height, bool opaque) {
  std::mt19937 random(7);
  render::Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool noise = x > width / 2;
      for (int c = 0; c < 3; ++c) {
        image.rgba.push_back(static_cast<std::uint8_t>(noise ? random() : static_cast<unsigned>(x + 2 * y + 60 * c)));
      }
      image.rgba.push_back(static_cast<std::uint8_t>(opaque ? 255 : 40 + (x + y) % 200));
    }
  }
  return image;
}

struct Decoded {
  int channels;  // in the file
  render::Image image;
};

Decoded decode(const std::vector<std::uint8_t>& file) {
  Decoded decoded{};
  unsigned char* pixels = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &decoded.image.width,
                                                &decoded.image.height, &decoded.channels, 4);
  if (pixels == nullptr) return decoded;
  const std::size_t bytes = 4 * static_cast<std::size_t>(decoded.image.width) * decoded.image.height;
  decoded.image.rgba.assign(pixels, pixels + bytes);
  stbi_image_free(pixels);
  return decoded;
}

TEST(Png, OpaqueImageComesBackAndHasNoAlpha) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {640, 3}, {233, 144}}) {
    const render::Image image = test_image(width, height, true);
    const Decoded decoded = decode(render::encode_png(image));
    EXPECT_EQ(decoded.channels, 3);
    EXPECT_EQ(decoded.image.width, width);
    EXPECT_EQ(decoded.image.height, height);
    EXPECT_EQ(decoded.image.rgba, image.rgba);
  }
}

TEST(Png, AlphaIsKept) {
  const render::Image image = test_image(97, 51, false);
  const Decoded decoded = decode(render::encode_png(image));
  EXPECT_EQ(decoded.channels, 4);
  EXPECT_EQ(decoded.image.rgba, image.rgba);
}

TEST(Png, SmoothPictureIsSmall) {
  render::Image image{256, 256, {}};
  for (int i = 0; i < 256 * 256; ++i) {
    const auto level = static_cast<std::uint8_t>(i / 256);
    image.rgba.insert(image.rgba.end(), {level, level, level, 255});
  }
  EXPECT_LT(render::encode_png(image).size(), 4000U);
}

TEST(Png, ThreadsEncodeTheSameBytes) {
  const render::Image image = test_image(300, 200, true);
  const std::vector<std::uint8_t> expected = render::encode_png(image);
  std::vector<std::vector<std::uint8_t>> files(4);
  std::vector<std::thread> threads;
  for (auto& file : files) threads.emplace_back([&image, &file] { file = render::encode_png(image); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& file : files) EXPECT_EQ(file, expected);
}

TEST(Png, SizeAndBytesMustMatch) {
  EXPECT_THROW(render::encode_png({0, 0, {}}), std::invalid_argument);
  EXPECT_THROW(render::encode_png({-4, 1, {}}), std::invalid_argument);
  EXPECT_THROW(render::encode_png({2, 2, std::vector<std::uint8_t>(15)}), std::invalid_argument);
  EXPECT_THROW(render::encode_png({70000, 70000, {}}), std::invalid_argument);
}

}  // namespace
