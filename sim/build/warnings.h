// What a user should know of a system before it runs. Bodies are put to the test for it, so it is asked for where it is
// shown, and not whenever a system is built: the window builds one for every move of a pulling mouse.
#pragma once

#include "sim/build/parts.h"

namespace sim {

// Elements that lock, energies without a least value, mass matrices that cost an explicit scheme its cheapness.
std::vector<std::string> warnings(const Parts& parts);

}  // namespace sim
