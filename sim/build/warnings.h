// What a user should know of a system before it runs: said as remarks, nothing is changed.
#pragma once

#include "sim/build/parts.h"

namespace sim {

// Elements that lock, energies without a least value, mass matrices that cost an explicit scheme its cheapness.
void warn(Parts& parts);

}  // namespace sim
