#pragma once

#include <string_view>

namespace app {

constexpr std::string_view kVersion = "0.1";

}  // namespace app
