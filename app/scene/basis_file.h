// The bases of a scene's bodies as a file.
//
// Little-endian: "RITZBASE", version (u32), key (u64), seconds (f64), bodies (u64); of each body modes (i64), the
// numbers of U (u64 and f64, column by column), whether it has a cubature (i64), and that: elements (u64 and f64),
// weights (u64 and f64), error (f64), states (i64); FNV-1a of all before it (u64).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene.h"

namespace app {

struct KeptBases {
  double seconds = 0;                                               // that it took to make them
  std::vector<std::shared_ptr<const sim::BasisVectors>> of_bodies;  // body by body
};

// key: of what they were made from.
std::string encode(const KeptBases& bases, std::uint64_t key);

// Throws std::runtime_error, beginning with `name`, when the bytes are not a whole file of bases for this scene and
// this key: cut short, changed, of another version or another scene, or with numbers that no basis has.
KeptBases decode_bases(std::string_view bytes, std::uint64_t key, const sim::Scene& scene, const std::string& name);

}  // namespace app
