// Runs of cases on the disk, so that nothing is run twice: a line-based head in TOML, then the numbers of the path.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/trade/case.h"

namespace app {

std::string encode(const CaseRun& run);
// Nothing where the bytes are not a whole run of this version.
std::optional<CaseRun> decode_case(std::string_view bytes);

}  // namespace app
