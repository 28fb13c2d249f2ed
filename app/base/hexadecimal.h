// Hashes as text.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace app {

// Sixteen digits.
inline std::string hexadecimal(std::uint64_t number) {
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(number));
  return digits;
}

}  // namespace app
