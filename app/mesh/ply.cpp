#include "app/mesh/ply.h"

#include <array>
#include <bit>
#include <cmath>

#include "app/mesh/binary.h"
#include "app/mesh/face_set.h"

namespace app {
namespace {

struct PlyType {
  std::string_view name, other_name;
  std::size_t size;  // bytes
  double (*read)(std::string_view bytes, bool swapped);
};

template <class T>
double read_as(std::string_view bytes, bool swapped) {
  return static_cast<double>(from_bytes<T>(bytes, swapped));
}

constexpr std::array<PlyType, 8> ply_types = {{{"char", "int8", 1, read_as<std::int8_t>},
                                               {"uchar", "uint8", 1, read_as<std::uint8_t>},
                                               {"short", "int16", 2, read_as<std::int16_t>},
                                               {"ushort", "uint16", 2, read_as<std::uint16_t>},
                                               {"int", "int32", 4, read_as<std::int32_t>},
                                               {"uint", "uint32", 4, read_as<std::uint32_t>},
                                               {"float", "float32", 4, read_as<float>},
                                               {"double", "float64", 8, read_as<double>}}};

struct PlyProperty {
  std::string name;
  const PlyType* length = nullptr;  // of a list's length; nullptr: not a list
  const PlyType* type = nullptr;
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool text = true, swapped = false;
  std::vector<PlyElement> elements;
};

const PlyType* read_ply_type(Cursor& in) {
  const std::string_view word = in.word("a type");
  for (const PlyType& type : ply_types) {
    if (type.name == word || type.other_name == word) return &type;
  }
  in.fail(quote(word) + " is not a type of PLY: char, uchar, short, ushort, int, uint, float, double");
}

PlyProperty read_property(Cursor& in) {
  PlyProperty property;
  const std::size_t start = in.position();
  if (in.word("a type") == "list") {
    property.length = read_ply_type(in);
  } else {
    in.go_to(start);
  }
  property.type = read_ply_type(in);
  property.name = in.word("the name of a property");
  return property;
}

void read_ply_format(Cursor& in, PlyHeader& header) {
  constexpr bool little = std::endian::native == std::endian::little;
  const std::string_view format = in.word("the format");
  header.text = format == "ascii";
  header.swapped = format == (little ? "binary_big_endian" : "binary_little_endian");
  if (!header.text && !header.swapped && format != "binary_little_endian" && format != "binary_big_endian") {
    in.fail("the format is " + quote(format) + "; it should be ascii, binary_little_endian or binary_big_endian");
  }
}

PlyHeader read_ply_header(Cursor& in) {
  in.expect("ply");
  PlyHeader header;
  for (;;) {
    const std::string_view word = in.word("end_header");
    if (word == "format") {
      read_ply_format(in, header);
    } else if (word == "element") {
      PlyElement& element = header.elements.emplace_back();
      element.name = in.word("the name of an element");
      element.count = in.whole("the number of elements");
    } else if (word == "property") {
      if (header.elements.empty()) in.fail("a property stands before the first element");
      header.elements.back().properties.push_back(read_property(in));
    } else if (word != "comment" && word != "obj_info" && word != "end_header") {
      in.fail(quote(word) + " stands where element, property or end_header should be");
    }
    in.rest_of_line();
    if (word == "end_header") return header;
  }
}

class PlyBody {
 public:
  PlyBody(Cursor& in, const PlyHeader& header, FaceSet& faces) : in_(in), header_(header), faces_(faces) {}

  void read() {
    if (!header_.text) in_.use_offsets();
    for (const PlyElement& element : header_.elements) {
      std::size_t bytes = 0;
      for (const PlyProperty& property : element.properties)
        bytes += header_.text ? 2 : (property.length ? property.length : property.type)->size;
      if (bytes == 0) in_.fail("the element " + quote(element.name) + " has no properties");
      const int count = in_.checked_count(element.count, bytes, "the number of " + element.name);
      for (int i = 0; i < count; ++i) read_one(element);
    }
  }

 private:
  double number(const PlyType& type, std::string_view what) {
    if (header_.text) return in_.real(what);
    const double x = type.read(in_.bytes(type.size, what), header_.swapped);
    if (!std::isfinite(x)) in_.fail(std::string(what) + " is not a finite number");
    return x;
  }

  std::int64_t whole(const PlyType& type, std::string_view what) {
    constexpr double exact = 9007199254740992;  // 2^53
    const double x = number(type, what);
    if (x != std::floor(x) || std::abs(x) > exact) in_.fail(std::string(what) + " should be a whole number");
    return static_cast<std::int64_t>(x);
  }

  // What nobody reads may be any number, or none.
  void pass_over(const PlyType& type) {
    if (header_.text) {
      in_.word("a property");
    } else {
      in_.bytes(type.size, "a property");
    }
  }

  void read_list(const PlyProperty& property, bool is_face) {
    const int count = in_.checked_count(whole(*property.length, "the length of a list"),
                                        header_.text ? 2 : property.type->size, "the length of a list");
    std::vector<int> corners;
    for (int i = 0; i < count; ++i) {
      if (is_face) {
        corners.push_back(faces_.checked_vertex(in_, whole(*property.type, "a corner of a face")));
      } else {
        pass_over(*property.type);
      }
    }
    if (is_face) faces_.add(in_, corners);
  }

  void read_one(const PlyElement& element) {
    const bool is_vertex = element.name == "vertex";
    Eigen::Vector3d X = Eigen::Vector3d::Zero();
    for (const PlyProperty& property : element.properties) {
      if (property.length) {
        read_list(property,
                  element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index"));
        continue;
      }
      if (is_vertex && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z') {
        X[property.name[0] - 'x'] = number(*property.type, property.name);
      } else {
        pass_over(*property.type);
      }
    }
    if (is_vertex) faces_.vertices.push_back(X);
  }

  Cursor& in_;
  const PlyHeader& header_;
  FaceSet& faces_;
};

}  // namespace

sim::Mesh read_ply(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name);
  const PlyHeader header = read_ply_header(in);
  FaceSet faces(0);
  PlyBody(in, header, faces).read();
  return faces.mesh(in, remarks);
}

}  // namespace app
