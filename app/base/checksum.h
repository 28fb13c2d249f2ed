// FNV-1a, 64 bits: for recognising files and scenes, not for secrets (Fowler, Noll, Vo; parameters of RFC 9923).
#pragma once

#include <cstdint>
#include <string_view>

namespace app {

constexpr std::uint64_t kEmptyChecksum = 0xcbf29ce484222325;

// Checksum of `bytes` appended to what has the checksum `before`.
constexpr std::uint64_t checksum(std::string_view bytes, std::uint64_t before = kEmptyChecksum) {
  for (const char byte : bytes) before = (before ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return before;
}

}  // namespace app
