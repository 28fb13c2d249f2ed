#include "sim/state.h"

#include "sim/math/checksum.h"

namespace sim {

std::uint64_t hash(const State& state) {
  std::uint64_t h = empty_checksum;
  const auto mix = [&](const void* data, std::size_t bytes) {
    h = checksum({static_cast<const char*>(data), bytes}, h);
  };
  for_each_field(state, [&](const auto& field) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(field)>>)
      mix(&field, sizeof field);
    else
      mix(field.data(), static_cast<std::size_t>(field.size()) * sizeof(double));
  });
  return h;
}

}  // namespace sim
