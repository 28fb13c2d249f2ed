// FNV-1a, 64 bits: for recognising states, files and scenes, not for secrets (Fowler, Noll, Vo; parameters of RFC
// 9923).
#pragma once

#include <cstdint>
#include <string_view>

namespace sim {

constexpr std::uint64_t empty_checksum = 0xcbf29ce484222325;

// Checksum of `bytes` appended to what has the checksum `before`.
constexpr std::uint64_t checksum(std::string_view bytes, std::uint64_t before = empty_checksum) {
  for (const char byte : bytes) before = (before ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return before;
}

}  // namespace sim
