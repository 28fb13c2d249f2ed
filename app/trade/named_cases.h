// The runs that --show names.
#pragma once

#include <filesystem>
#include <vector>

#include "app/trade/comparison.h"

namespace app {

// The cases of these names: those that lie in the folder of an earlier trade or, unless only these are asked for
// (--collect), that a trade of the scene can make. Asked before anything is run or written, so that a wrong name costs
// nothing. Throws std::runtime_error, which says what names there are.
std::vector<TradeCase> named_cases(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace app
