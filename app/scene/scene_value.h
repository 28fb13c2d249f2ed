// Values of keys in TOML, read and checked.
#pragma once

#include <toml++/toml.h>

#include <string>

#include "app/scene/keys.h"

namespace app {

struct ScannedValue {
  Value value;
  int dimension = 0;  // of a point, direction, box or ball: how many numbers a point was given; else 0
};

// The node as a value of this form. Throws std::invalid_argument that says what would be right ("must be > 0").
ScannedValue scan_value(const Form& form, const toml::node& node);

// The node as TOML on one line.
std::string node_literal(const toml::node& node);

// The node as a message shows it: on one line, shortened when it is long.
std::string node_text(const toml::node& node);

// `name` stands for the file in the messages. Throws SceneError, "FILE:LINE: ...", for what is not TOML.
toml::table parsed(std::string_view text, const std::string& name);

}  // namespace app
