// A number in the bytes of a file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

namespace app {

// The first sizeof(T) bytes of `bytes`, which has as many. swapped: they are in the order that this machine's are not.
template <class T>
T from_bytes(std::string_view bytes, bool swapped) {
  std::array<char, sizeof(T)> raw;
  std::copy_n(bytes.data(), sizeof(T), raw.data());
  if (swapped) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

}  // namespace app
