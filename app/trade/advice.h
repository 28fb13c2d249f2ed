// Which settings to take.
#pragma once

#include <string>
#include <vector>

#include "app/trade/goal.h"
#include "app/trade/score.h"

namespace app {

// The runs whose error is known and that no other beats in time and error, fastest first.
std::vector<const Score*> front_of(const std::vector<const Score*>& scores);

// Within the error: the fastest; within the time: the most accurate; else the knee of the front, among what is no less
// accurate than the scene as it is. Where nothing is within the goal, the nearest. nullptr when no error is known.
const Score* choose(const std::vector<const Score*>& scores, const Goal& goal);

// Whether what is known of the run is within the goal.
bool meets(const Score& score, const Goal& goal);

// advice.toml: the case's settings, as keys that overlay the scene.
std::string advice_toml(const TradeCase& which, const std::string& comment);

}  // namespace app
