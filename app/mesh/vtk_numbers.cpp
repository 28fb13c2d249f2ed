#include "app/mesh/vtk_numbers.h"

namespace app {
namespace {

template <class T>
constexpr VtkType type_of(std::string_view names) {
  return {names, sizeof(T), std::is_integral_v<T>,
          [](std::string_view bytes, bool swapped) { return static_cast<std::int64_t>(from_bytes<T>(bytes, swapped)); },
          [](std::string_view bytes, bool swapped) { return static_cast<double>(from_bytes<T>(bytes, swapped)); }};
}

// [VTK file formats]. vtkIdType is written with four bytes to legacy files.
constexpr std::array<VtkType, 10> vtk_types = {type_of<std::int8_t>("char signed_char Int8 "),
                                               type_of<std::uint8_t>("unsigned_char UInt8 "),
                                               type_of<std::int16_t>("short Int16 "),
                                               type_of<std::uint16_t>("unsigned_short UInt16 "),
                                               type_of<std::int32_t>("int vtkIdType Int32 "),
                                               type_of<std::uint32_t>("unsigned_int UInt32 "),
                                               type_of<std::int64_t>("long vtktypeint64 Int64 "),
                                               type_of<std::uint64_t>("unsigned_long vtktypeuint64 UInt64 "),
                                               type_of<float>("float Float32 "),
                                               type_of<double>("double Float64 ")};

}  // namespace

const VtkType& vtk_type(const Cursor& in, std::string_view name) {
  for (const VtkType& type : vtk_types) {
    if ((" " + std::string(type.names)).find(" " + std::string(name) + " ") != std::string::npos) return type;
  }
  in.fail(quote(name) + " is not a type of numbers that is read");
}

}  // namespace app
