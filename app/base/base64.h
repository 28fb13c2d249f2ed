// Bytes as base64 text (RFC 4648), padded.
#pragma once

#include <string>
#include <string_view>

namespace app {

std::string base64(std::string_view bytes);

}  // namespace app
