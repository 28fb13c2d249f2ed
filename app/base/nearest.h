// The name that someone meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace app {

// The name with the least edit distance (insertions, deletions, replacements and swaps of neighbours, letter case
// ignored) from `given`; empty when even that is further than a third of its length, but at least 2.
std::string_view nearest(std::string_view given, std::span<const std::string_view> names);

// That name as the end of a message, `; did you mean "neo-hookean"?`; empty when there is none.
std::string suggestion(std::string_view given, std::span<const std::string_view> names);

}  // namespace app
