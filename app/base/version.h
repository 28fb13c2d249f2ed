#pragma once

#include <string_view>

namespace app {

constexpr std::string_view ritz_version = "0.1";

}  // namespace app
