// One input of the fuzzer for state.bin, and what must hold for whatever it is: a state that is written as the same
// bytes, or an error. The checksum is put right, or no input would come further than it.
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/run/state_file.h"
#include "sim/math/checksum.h"

namespace app {

inline bool try_state_input(std::string_view input) {
  std::string bytes(input);
  const std::uint64_t sum = sim::checksum(input);
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>(sum >> (8 * i) & 0xff));
  try {
    const SavedRun run = decode(bytes, "state.bin");
    if (encode(run) != bytes) std::abort();
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace app
