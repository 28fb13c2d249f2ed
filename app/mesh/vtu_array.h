// An array of numbers in a VTK XML file.
#pragma once

#include <string>
#include <vector>

#include "app/mesh/vtk_numbers.h"
#include "app/mesh/xml_tags.h"

namespace app {

// How all arrays of a file are written.
struct VtuCoding {
  bool swapped = false;      // bytes are in the order that this machine's are not
  bool wide = false;         // counts of bytes have 64 bits, not 32
  bool compressed = false;   // blocks by zlib
  bool appended_raw = true;  // the appended data are bytes, not base64
  std::size_t appended = 0;  // place of the first byte of the appended data; 0: there are none
};

// The numbers of a tag DataArray. Fails where they cannot be had.
template <class T>
std::vector<T> read_vtu_array(Cursor& in, const XmlTag& tag, const VtuCoding& coding);

}  // namespace app
