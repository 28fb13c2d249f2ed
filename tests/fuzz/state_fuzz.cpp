// clang++ -std=c++20 -g -O1 -march=native -fsanitize=fuzzer,address,undefined -I. -isystem /usr/include/eigen3
//   tests/fuzz/state_fuzz.cpp app/run/state_file.cpp app/base/output_file.cpp -o state_fuzz
// state_fuzz -rss_limit_mb=512 -timeout=1 -max_len=4096 NEW_CORPUS tests/data/fuzz-state
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/state_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  app::try_state_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
