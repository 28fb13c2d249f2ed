#include "render/png.h"

#include <libdeflate.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

// Deflates into a zlib stream that the caller frees; null when that fails. Signature and ownership are stb's, whose
// own compressor is several times slower. Level 4 of 12 is where more effort stops to pay for frames of a video.
unsigned char* deflate(unsigned char* data, int size, int* written, int /*quality*/) {
  constexpr int level = 4;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (!compressor) return nullptr;
  const auto length = static_cast<std::size_t>(size);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), length);
  std::unique_ptr<unsigned char, decltype(&std::free)> stream(static_cast<unsigned char*>(std::malloc(bound)),
                                                              std::free);
  if (!stream) return nullptr;
  *written = static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, length, stream.get(), bound));
  return *written > 0 ? stream.release() : nullptr;
}

}  // namespace

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS deflate
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // stb brings writers of other formats along
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace render {
namespace {

bool opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

std::vector<std::uint8_t> without_alpha(const Image& image) {
  std::vector<std::uint8_t> rgb(image.rgba.size() / 4 * 3);
  for (std::size_t from = 0, to = 0; from < image.rgba.size(); from += 4, to += 3) {
    rgb[to] = image.rgba[from];
    rgb[to + 1] = image.rgba[from + 1];
    rgb[to + 2] = image.rgba[from + 2];
  }
  return rgb;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  const bool sized = image.width > 0 && image.height > 0 && image.width <= 16384 && image.height <= 16384;
  if (!sized || image.rgba.size() != 4 * static_cast<std::size_t>(image.width) * image.height) {
    throw std::invalid_argument("PNG: an image of " + std::to_string(image.width) + " x " +
                                std::to_string(image.height) + " pixels cannot have " +
                                std::to_string(image.rgba.size()) + " bytes");
  }
  const bool drop_alpha = opaque(image);
  const std::vector<std::uint8_t> rgb = drop_alpha ? without_alpha(image) : std::vector<std::uint8_t>{};
  const int channels = drop_alpha ? 3 : 4;
  // stb keeps its choice of row filter in a variable, set here once, before any thread reads it: the difference to the
  // left neighbour (1). Trying all filters for each row takes twice the time of deflating and saves nothing.
  [[maybe_unused]] static const int filter = stbi_write_force_png_filter = 1;
  int size = 0;
  const std::unique_ptr<unsigned char, decltype(&std::free)> file(
      stbi_write_png_to_mem(drop_alpha ? rgb.data() : image.rgba.data(), image.width * channels, image.width,
                            image.height, channels, &size),
      std::free);
  if (!file) throw std::runtime_error("PNG: no memory to encode the image");
  return {file.get(), file.get() + size};
}

Image decode_png(std::string_view bytes) {
  Image image;
  int channels = 0;
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const std::unique_ptr<unsigned char, decltype(&std::free)> pixels(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &image.width, &image.height, &channels, 4),
      std::free);
  if (!pixels) throw std::invalid_argument(std::string("is not a PNG picture (") + stbi_failure_reason() + ")");
  image.rgba.assign(pixels.get(), pixels.get() + 4 * static_cast<std::size_t>(image.width) * image.height);
  return image;
}

}  // namespace render
