#include "app/mesh/msh_fields.h"

#include <cmath>
#include <limits>

#include "app/mesh/binary.h"

namespace app {

template <class T>
T MshFields::value(std::string_view what) {
  return from_bytes<T>(cursor_.bytes(sizeof(T), what), swapped_);
}

int MshFields::integer(std::string_view what, int low, int high) {
  if (!binary_) return static_cast<int>(cursor_.integer(what, low, high));
  const auto found = value<std::int32_t>(what);
  if (found < low || found > high) {
    cursor_.fail(std::string(what) + " is " + std::to_string(found) + "; it should be from " + std::to_string(low) +
                 " to " + std::to_string(high));
  }
  return found;
}

int MshFields::tag(std::string_view what) {
  constexpr int most = std::numeric_limits<int>::max();
  return integer(what, -most, most);
}

std::int64_t MshFields::size(std::string_view what) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  if (!binary_) return cursor_.whole(what);
  const auto found = value<std::uint64_t>(what);
  if (found > static_cast<std::uint64_t>(most)) {
    cursor_.fail(std::string(what) + " is " + std::to_string(found) + ", more than any file can hold");
  }
  return static_cast<std::int64_t>(found);
}

double MshFields::real(std::string_view what) {
  if (!binary_) return cursor_.real(what);
  const auto found = value<double>(what);
  if (!std::isfinite(found)) {
    cursor_.fail(std::string(what) + " is " + std::to_string(found) + "; it should be a finite number");
  }
  return found;
}

int MshFields::count(std::string_view what, std::size_t text_bytes_each, std::size_t binary_bytes_each) {
  return cursor_.checked_count(size(what), binary_ ? binary_bytes_each : text_bytes_each, what);
}

}  // namespace app
