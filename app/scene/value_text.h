// Values as text that is both TOML and JSON.
#pragma once

#include <string>
#include <string_view>

#include "app/scene/keys.h"

namespace app {

// The shortest digits that read back as the same number, always as a float: "2.0", "1e+06".
std::string number_literal(double x);

// `dimension`: how many numbers a point has.
std::string value_text(const Key& key, const Value& value, int dimension);

}  // namespace app
