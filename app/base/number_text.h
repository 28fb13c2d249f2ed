// Numbers as text for files: the shortest digits that read back as the same number, in every locale.
#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace app {

template <typename Number>
requires std::integral<Number> || std::floating_point<Number>
void append_number(std::string& text, Number value) {
  char digits[32];
  const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end.ptr);
}

}  // namespace app
