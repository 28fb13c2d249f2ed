// clang++ -std=c++20 -g -O1 -DNDEBUG -march=native -fsanitize=fuzzer,address,undefined
//   -fno-sanitize=unreachable -I. -isystem /usr/include/eigen3
//   tests/fuzz/scene_fuzz.cpp app/{base,mesh,scene,scene/keys}/*.cpp sim/mesh/*.cpp sim/time/scheme.cpp
//   render/colour_map.cpp build/libsim.a -fopenmp=libgomp -lcholmod -lopenblas -ltomlplusplus -o scene_fuzz
// scene_fuzz -rss_limit_mb=1024 -timeout=5 -max_len=4096 -dict=tests/fuzz/scene.dict NEW_CORPUS tests/data/fuzz-scene
// (Outside strings toml++ 3.3 has characters for which it reaches what it calls unreachable: an error all the same.)
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/scene_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  app::try_scene_input({reinterpret_cast<const char*>(data), size}, "/dev/shm/ritz-scene-fuzz.toml");
  return 0;
}
