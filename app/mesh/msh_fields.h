// The numbers of a Gmsh file, one after the other, whether they are written as text or as bytes.
#pragma once

#include <cstdint>
#include <string_view>

#include "app/mesh/cursor.h"

namespace app {

class MshFields {
 public:
  // swapped: the bytes come from a machine of the other byte order.
  MshFields(Cursor& cursor, bool binary, bool swapped) : cursor_(cursor), binary_(binary), swapped_(swapped) {}

  Cursor& cursor() { return cursor_; }
  bool binary() const { return binary_; }

  // A 32-bit integer, from low to high.
  int integer(std::string_view what, int low, int high);
  // A 32-bit integer of whatever value but the lowest, so that its sign can be dropped.
  int tag(std::string_view what);
  // A 64-bit unsigned integer (below 2^63: no counted or numbered thing is more).
  std::int64_t size(std::string_view what);
  // A finite number, 64 bits.
  double real(std::string_view what);

  // size() as a count of items that each take so many bytes in text and in binary.
  int count(std::string_view what, std::size_t text_bytes_each, std::size_t binary_bytes_each);

 private:
  template <class T>
  T value(std::string_view what);

  Cursor& cursor_;
  bool binary_, swapped_;
};

}  // namespace app
