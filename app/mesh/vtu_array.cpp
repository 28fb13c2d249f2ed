#include "app/mesh/vtu_array.h"

#include <libdeflate.h>

#include <algorithm>
#include <memory>

#include "app/base/base64.h"

namespace app {
namespace {

// The bytes of a binary array. In front stands their count; or, compressed, the number of blocks, the size of each, of
// the last one (0: as the others), and of each when compressed. base64 is of the counts and of the blocks by themselves
// where they are compressed. [VTK file formats, XML]
class VtuBytes {
 public:
  VtuBytes(Cursor& in, const VtuCoding& coding, bool base64) : in_(in), coding_(coding), base64_(base64) {}

  std::string read() {
    if (!coding_.compressed) {
      if (!base64_) return std::string(in_.bytes(static_cast<std::size_t>(count(counts(1), 0)), "an array"));
      const std::string all = decoded(in_.left());
      const std::int64_t size = count(all, 0);
      if (size > static_cast<std::int64_t>(all.size() - width())) in_.fail("the array is shorter than its count says");
      return all.substr(width(), static_cast<std::size_t>(size));
    }
    const std::size_t start = in_.position();
    const std::int64_t blocks = count(counts(3), 0);
    if (blocks == 0) return {};
    in_.go_to(start);
    const std::string sizes =
        counts(3 + static_cast<std::size_t>(in_.checked_count(blocks, 1, "the number of blocks")));
    return inflated(sizes, blocks);
  }

 private:
  std::size_t width() const { return coding_.wide ? 8 : 4; }

  // The next `number` counts as bytes.
  std::string counts(std::size_t number) {
    const std::size_t size = number * width();
    std::string bytes = base64_ ? decoded((size + 2) / 3 * 4) : std::string(in_.bytes(size, "a count"));
    if (bytes.size() < size) in_.fail("the array has no count of its bytes");
    return bytes;
  }

  // What so many letters, or all up to the end of the text, say.
  std::string decoded(std::size_t letters) {
    in_.finished();
    std::string_view text = in_.bytes(std::min(letters, in_.left()), "base64");
    text = text.substr(0, text.find('<'));
    auto bytes = from_base64(text);
    if (!bytes) in_.fail("the text is not base64");
    if (bytes->size() < width()) in_.fail("the array has no count of its bytes");
    return std::move(*bytes);
  }

  std::int64_t count(const std::string& bytes, std::size_t i) const {
    const std::string_view at = std::string_view(bytes).substr(i * width());
    const std::uint64_t value =
        coding_.wide ? from_bytes<std::uint64_t>(at, coding_.swapped) : from_bytes<std::uint32_t>(at, coding_.swapped);
    if (value > std::uint64_t{1} << 40) in_.fail("an array of " + std::to_string(value) + " bytes does not fit here");
    return static_cast<std::int64_t>(value);
  }

  std::string inflated(const std::string& sizes, std::int64_t blocks) {
    std::size_t packed_size = 0;
    for (std::int64_t b = 0; b < blocks; ++b)
      packed_size += static_cast<std::size_t>(count(sizes, static_cast<std::size_t>(3 + b)));
    const std::string packed =
        base64_ ? decoded((packed_size + 2) / 3 * 4) : std::string(in_.bytes(packed_size, "compressed bytes"));
    if (packed.size() < packed_size) in_.fail("the compressed bytes are fewer than their counts say");
    constexpr std::size_t most = 1032;  // times that zlib can make bytes fewer
    const auto size = static_cast<std::size_t>(count(sizes, 1)), last = static_cast<std::size_t>(count(sizes, 2));
    const std::size_t full = static_cast<std::size_t>(blocks) - (last > 0 ? 1 : 0);
    if (last > most * packed_size || (full > 0 && size > most * packed_size / full))
      in_.fail("the array would be longer than its bytes can make it");
    std::string result(full * size + last, '\0');
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> zlib(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    std::size_t from = 0, to = 0;
    for (std::size_t b = 0; b < static_cast<std::size_t>(blocks); ++b) {
      const auto length = static_cast<std::size_t>(count(sizes, 3 + b));
      const std::size_t wanted = b < full ? size : last;
      if (libdeflate_zlib_decompress(zlib.get(), packed.data() + from, length, result.data() + to, wanted, nullptr) !=
          LIBDEFLATE_SUCCESS)
        in_.fail("a compressed block is damaged");
      from += length;
      to += wanted;
    }
    return result;
  }

  Cursor& in_;
  const VtuCoding& coding_;
  bool base64_;
};

// Up to the next tag, which may follow a number without a blank.
template <class T>
void read_words(Cursor& in, std::vector<T>& numbers) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t start = in.position();
  const std::string_view text = in.up_to('<');
  for (std::size_t at = text.find_first_not_of(blanks); at != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    T number{};
    if (!parse(text.substr(at, end - at), number)) {
      in.go_to(start + at);
      in.word("a number");  // errors point at it
      in.fail("a number is " + quote(text.substr(at, end - at)) + "; it should be " +
              (std::is_same_v<T, double> ? "a real number" : "a whole number of 64 bits"));
    }
    numbers.push_back(number);
    at = text.find_first_not_of(blanks, end);
  }
}

}  // namespace

template <class T>
std::vector<T> read_vtu_array(Cursor& in, const XmlTag& tag, const VtuCoding& coding) {
  in.go_to(tag.text_at);
  in.bytes(0, "an array");  // errors point at it
  const VtkType& type = vtk_type(in, tag.attribute("type"));
  if (std::is_same_v<T, std::int64_t> && !type.integer) in.fail("whole numbers should stand here");
  const std::string format = tag.attribute("format");
  std::vector<T> numbers;
  if (format == "ascii") {
    read_words(in, numbers);
    return numbers;
  }
  const bool appended = format == "appended";
  if (appended) {
    std::int64_t offset = 0;
    if (!parse(tag.attribute("offset"), offset) || offset < 0 || coding.appended == 0)
      in.fail("an appended array needs its offset, and the file appended data");
    in.go_to(coding.appended);
    in.bytes(static_cast<std::size_t>(in.checked_count(offset, 1, "the offset of an array")), "the offset of an array");
  } else if (format != "binary") {
    in.fail("the format of an array is " + quote(format) + "; it should be ascii, binary or appended");
  }
  const std::string bytes = VtuBytes(in, coding, !appended || !coding.appended_raw).read();
  numbers.reserve(bytes.size() / type.size);
  for (std::size_t at = 0; at + type.size <= bytes.size(); at += type.size)
    numbers.push_back(vtk_number<T>(type, std::string_view(bytes).substr(at), coding.swapped));
  return numbers;
}

template std::vector<double> read_vtu_array<double>(Cursor&, const XmlTag&, const VtuCoding&);
template std::vector<std::int64_t> read_vtu_array<std::int64_t>(Cursor&, const XmlTag&, const VtuCoding&);

}  // namespace app
