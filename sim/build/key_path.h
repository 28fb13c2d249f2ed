// Paths of scene keys, for messages.
#pragma once

#include <string>

#include "sim/mesh/input_error.h"

namespace sim {

inline std::string key_of(const char* list, std::size_t k) {
  return std::string(list) + "." + std::to_string(k);
}

// Calls f; errors that name a key below `prefix` then name the whole path.
template <class F>
auto below(const std::string& prefix, const F& f) {
  try {
    return f();
  } catch (const InputError& error) {
    throw InputError(prefix + "." + error.key, error.what());
  }
}

}  // namespace sim
