// Bytes as base64 text (RFC 4648), padded.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace app {

std::string base64(std::string_view bytes);

// The bytes of such a text up to its end or its padding; blanks are passed over. Nothing, when it is no such text.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace app
