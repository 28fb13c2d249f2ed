// clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I. -isystem /usr/include/eigen3
//   tests/fuzz/mesh_fuzz.cpp app/mesh/*.cpp app/base/base64.cpp sim/element/element.cpp
//   sim/mesh/boundary.cpp -ldeflate -o mesh_fuzz
// mesh_fuzz -rss_limit_mb=512 -timeout=1 -max_len=4096 NEW_CORPUS tests/data/fuzz tests/data
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/mesh_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  app::try_mesh_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
