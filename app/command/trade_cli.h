// The options of `ritz trade` on the command line.
#pragma once

#include "app/options/options.h"

namespace CLI {
class App;
}

namespace app {

void add_trade_options(CLI::App& command, Options& options);

}  // namespace app
