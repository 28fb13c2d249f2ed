// clang++ -std=c++20 -g -O1 -DNDEBUG -march=native -fsanitize=fuzzer,address,undefined
//   -fno-sanitize=unreachable -I. -isystem /usr/include/eigen3
//   tests/fuzz/session_fuzz.cpp app/session/session_{file,log}.cpp app/{base,mesh,scene,scene/keys}/*.cpp
//   sim/mesh/*.cpp sim/time/scheme.cpp render/colour_map.cpp build/libsim.a -fopenmp=libgomp -lcholmod -lopenblas
//   -ltomlplusplus -o session_fuzz
// session_fuzz -rss_limit_mb=512 -timeout=1 -max_len=4096 -dict=tests/fuzz/scene.dict NEW_CORPUS
//   tests/data/fuzz-session
// (Outside strings toml++ 3.3 has characters for which it reaches what it calls unreachable: an error all the same.)
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/session_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  app::try_session_input({reinterpret_cast<const char*>(data), size}, "/dev/shm/ritz-session-fuzz.toml");
  return 0;
}
