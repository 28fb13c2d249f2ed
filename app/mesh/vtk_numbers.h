// Types of numbers in VTK files, and arrays of them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/mesh/binary.h"
#include "app/mesh/cursor.h"

namespace app {

struct VtkType {
  std::string_view names;  // in legacy files and in XML, a blank behind each
  std::size_t size;        // bytes
  bool integer;
  std::int64_t (*whole)(std::string_view bytes, bool swapped);
  double (*real)(std::string_view bytes, bool swapped);
};

// Fails when there is no such type.
const VtkType& vtk_type(const Cursor& in, std::string_view name);

// One number of the type.
template <class T>
T vtk_number(const VtkType& type, std::string_view bytes, bool swapped) {
  if constexpr (std::is_same_v<T, double>) return type.real(bytes, swapped);
  return type.whole(bytes, swapped);
}

// `count` numbers, as T (double, or std::int64_t where the type is of whole numbers), written as text or bytes. Fails
// when there are fewer, or a real number where a whole one should be.
template <class T>
std::vector<T> read_vtk_numbers(Cursor& in, const VtkType& type, bool binary, bool swapped, std::int64_t count) {
  if (std::is_same_v<T, std::int64_t> && !type.integer) in.fail("whole numbers should stand here");
  const auto n = static_cast<std::size_t>(in.checked_count(count, binary ? type.size : 2, "the number of values"));
  std::vector<T> numbers;
  numbers.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (binary) {
      numbers.push_back(vtk_number<T>(type, in.bytes(type.size, "a number"), swapped));
    } else if constexpr (std::is_same_v<T, double>) {
      numbers.push_back(in.real("a number"));
    } else {
      numbers.push_back(in.whole("a number"));
    }
  }
  return numbers;
}

}  // namespace app
