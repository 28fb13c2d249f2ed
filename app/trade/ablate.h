// `ritz trade --ablate`: what each feature of a scene costs, and what it changes.
#pragma once

#include "app/options/options.h"

namespace app {

// Removes one at a time and prints a table; writes ablate.csv. Returns the exit code.
int ablate(const Options& options);

}  // namespace app
