// Every material, by type: a new one is its file and a line here.
#pragma once

#include "sim/material/corotated.h"
#include "sim/material/fixed_corotated.h"
#include "sim/material/linear.h"
#include "sim/material/neo_hookean.h"
#include "sim/material/stable_neo_hookean.h"
#include "sim/material/stvk.h"
#include "sim/math/type_list.h"

namespace sim {

using Materials = TypeList<Linear, Corotated, StVK, FixedCorotated, NeoHookean, StableNeoHookean>;

}  // namespace sim
