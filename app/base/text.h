// Text that is made of numbers and of other text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace app {

// As printf writes it.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

// Sixteen digits.
std::string hexadecimal(std::uint64_t number);

// "1.5 %" of a share of 0.015.
std::string percent(double share);

// With capitals for small letters, of ASCII.
std::string in_capitals(std::string_view text);

// A string of JSON and of TOML: in quotes, what may not stand between them escaped.
std::string quoted_text(std::string_view text);

// A field of CSV in quotes, its own quotes doubled (RFC 4180); a line break becomes a blank, so that a row is a line.
std::string quoted_field(std::string_view text);

}  // namespace app
