#include "sim/state.h"

#include <cstring>

namespace sim {

std::uint64_t hash(const State& state) {
  std::uint64_t h = 14695981039346656037ull;
  const auto mix = [&](const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) h = (h ^ byte[i]) * 1099511628211ull;
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
