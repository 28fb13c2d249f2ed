// Numbers as the bytes of a file: little-endian, whatever the machine.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace app {

template <typename Unsigned>
void put(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xff));
}
inline void put(std::string& bytes, double value) {
  put(bytes, std::bit_cast<std::uint64_t>(value));
}
inline void put(std::string& bytes, std::int64_t value) {
  put(bytes, static_cast<std::uint64_t>(value));
}
// Its length and its numbers.
void put(std::string& bytes, const Eigen::VectorXd& values);
// Of all bytes before it.
void put_checksum(std::string& bytes);

// Takes numbers from the front of some bytes. Every call throws std::runtime_error where they end too early.
class ByteReader {
 public:
  // what: "state.bin: the saved state", the beginning of messages.
  ByteReader(std::string_view bytes, std::string what) : whole_(bytes), bytes_(bytes), what_(std::move(what)) {}

  std::string_view take(std::size_t count);
  template <typename Unsigned>
  Unsigned number() {
    Unsigned value = 0;
    int shift = 0;
    for (const char byte : take(sizeof(Unsigned))) {
      value |= static_cast<Unsigned>(static_cast<unsigned char>(byte)) << shift;
      shift += 8;
    }
    return value;
  }
  std::int64_t integer() { return static_cast<std::int64_t>(number<std::uint64_t>()); }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  Eigen::VectorXd vector();
  // The end: nothing is left but the checksum, and it is right.
  void take_checksum();

  [[noreturn]] void fail(const std::string& why) const;

 private:
  std::string_view whole_, bytes_;
  std::string what_;
};

}  // namespace app
