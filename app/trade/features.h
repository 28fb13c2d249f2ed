// What a scene could do without.
#pragma once

#include <vector>

#include "app/scene/document.h"
#include "app/trade/case.h"

namespace app {

// One case for each term or feature that the scene has: the scene without it. The label names it.
std::vector<TradeCase> without_features(const Document& scene);

}  // namespace app
