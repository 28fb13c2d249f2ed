// Input that cannot be built.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace sim {

// `key` is the path of the scene key at fault ("body.0.pin.0"), so that the program can say file and line.
struct InputError : std::runtime_error {
  std::string key;
  InputError(std::string key_, const std::string& what_) : std::runtime_error(what_), key(std::move(key_)) {}
};

}  // namespace sim
