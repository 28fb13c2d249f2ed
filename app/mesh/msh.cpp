#include "app/mesh/msh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <limits>

#include "app/mesh/msh1.h"
#include "app/mesh/msh2.h"
#include "app/mesh/msh4.h"
#include "app/mesh/msh40.h"
#include "app/mesh/msh_mesh.h"

namespace app {
namespace {

struct MshVersion {
  std::string_view names;  // in the file's head, a blank behind each
  std::string_view nodes_section, elements_section;
  int point_numbers;  // of an entity; 0: there are none
  void (*nodes)(MshFields&, MshContents&);
  void (*elements)(MshFields&, const MshEntities&, MshContents&);
};

constexpr std::array<MshVersion, 4> msh_versions = {
    {{"", "NOD", "ELM", 0, read_msh2_nodes,
      [](MshFields& in, const MshEntities&, MshContents& contents) { read_msh1_elements(in, contents); }},
     {"2 2.0 2.1 2.2 ", "Nodes", "Elements", 0, read_msh2_nodes,
      [](MshFields& in, const MshEntities&, MshContents& contents) { read_msh2_elements(in, contents); }},
     {"4 4.0 ", "Nodes", "Elements", 6, read_msh40_nodes, read_msh40_elements},
     {"4.1 ", "Nodes", "Elements", 3, read_msh4_nodes, read_msh4_elements}}};

struct Format {
  const MshVersion* version;
  bool binary = false;
  bool swapped = false;
};

// In binary files the integer 1 follows the line of the format: it tells the byte order.
bool read_byte_order(Cursor& in) {
  in.rest_of_line();
  in.use_offsets();
  std::array<char, 4> raw;
  in.bytes(4, "the byte order mark").copy(raw.data(), raw.size());
  const auto mark = std::bit_cast<std::int32_t>(raw);
  if (mark != 1 && mark != 0x01000000) {
    in.fail("the byte order mark is " + std::to_string(mark) + "; it should be 1 in one byte order or the other");
  }
  return mark != 1;
}

// Behind $MeshFormat: version, 0 for text or 1 for binary, bytes of a real number (2.x) or a count (4.1).
Format read_format(Cursor& in) {
  const std::string_view name = in.word("the version of the MSH format");
  const auto version = std::ranges::find_if(msh_versions, [&](const MshVersion& v) {
    return (" " + std::string(v.names)).find(" " + std::string(name) + " ") != std::string::npos;
  });
  if (version == msh_versions.end()) {
    in.fail("MSH version " + quote(name) +
            " is not read; 1, 2.0 to 2.2, 4.0 and 4.1 are: gmsh -0 FILE -format msh41 -o NEW.msh writes the latter");
  }
  Format format{&*version, in.integer("the file type", 0, 1) == 1, false};
  in.integer("the data size", 8, 8);
  if (format.binary) format.swapped = read_byte_order(in);
  in.expect("$EndMeshFormat");
  return format;
}

// Always text: dimension, tag and "name" of each group.
void read_physical_names(Cursor& in, MshContents& contents) {
  constexpr int any = std::numeric_limits<int>::max();
  constexpr std::string_view what = "the number of physical names";
  const int count = in.checked_count(in.whole(what), 7, what);
  for (int i = 0; i < count; ++i) {
    const auto dimension = static_cast<int>(in.integer("the dimension of a physical group", 0, 3));
    const auto tag = static_cast<int>(in.integer("the tag of a physical group", 0, any));
    contents.names[{dimension, tag}] = in.quoted("the name of a physical group");
  }
}

// To behind the section's end, which is a word of its own; in binary no line need end before it.
void skip_section(Cursor& in, const std::string& section) {
  if (section.size() < 2 || section[0] != '$' || section.starts_with("$End")) {
    in.fail(quote(section) + " stands where a section such as $Nodes should begin");
  }
  if (section == "$ParametricNodes")
    in.fail(section + " is not read; gmsh -0 FILE -format msh41 -o NEW.msh writes nodes without parameters");
  const std::string end = "$End" + section.substr(1);
  do {
    if (!in.skip_past(end)) in.fail("the section " + quote(section) + " has no end " + quote(end));
  } while (in.left() > 0 && std::isspace(static_cast<unsigned char>(in.peek())) == 0);
}

// Up to the head, or the first section of version 1, which has none. Other sections may stand before.
Format find_format(Cursor& in) {
  for (;;) {
    const std::size_t start = in.position();
    const std::string section(in.word("$MeshFormat"));
    if (section == "$MeshFormat") return read_format(in);
    if (section == "$NOD") {
      in.go_to(start);
      return {&msh_versions[0]};
    }
    if (section == "$Nodes" || section == "$Elements")
      in.fail(section + " stands before $MeshFormat; it should follow");
    skip_section(in, section);
  }
}

class Sections {
 public:
  Sections(Cursor& in, const Format& format) : in_(in), format_(format), fields_(in, format.binary, format.swapped) {}

  // The sections in the order of the file, up to its end.
  MshContents read() {
    while (!in_.finished()) read_section(std::string(in_.word("a section")));
    if (!have_nodes_ || !have_elements_) {
      in_.fail("the file ends without a section $" +
               std::string(have_nodes_ ? format_.version->elements_section : format_.version->nodes_section));
    }
    return std::move(contents_);
  }

 private:
  void read_section(const std::string& section) {
    if (section == "$PhysicalNames") {
      read_physical_names(in_, contents_);
    } else if (section.substr(1) == format_.version->nodes_section) {
      start(section, have_nodes_);
      format_.version->nodes(fields_, contents_);
    } else if (section.substr(1) == format_.version->elements_section) {
      start(section, have_elements_);
      if (!have_nodes_) in_.fail("$Elements stands before $Nodes; it should follow");
      format_.version->elements(fields_, entities_, contents_);
    } else if (section == "$Entities" && format_.version->point_numbers > 0) {
      if (format_.binary) in_.rest_of_line();
      entities_ = read_msh4_entities(fields_, format_.version->point_numbers);
    } else if (section == "$PartitionedEntities" && format_.version->point_numbers > 0) {
      if (format_.binary) in_.rest_of_line();
      read_msh4_partitions(fields_, format_.version->point_numbers, entities_);
    } else {
      return skip_section(in_, section);
    }
    in_.expect(end_of(section));
  }

  // "$EndNodes", and "$ENDNOD" in version 1.
  std::string end_of(const std::string& section) const {
    return (format_.version == &msh_versions[0] ? "$END" : "$End") + section.substr(1);
  }

  // One such section only. In binary 4.1 its bytes start on the next line; 2.x has its count there, as text.
  void start(const std::string& section, bool& have) {
    if (have) in_.fail("a second section " + section + "; there should be one");
    have = true;
    if (format_.binary) in_.rest_of_line();
  }

  Cursor& in_;
  Format format_;
  MshFields fields_;
  MshContents contents_;
  MshEntities entities_;
  bool have_nodes_ = false, have_elements_ = false;
};

}  // namespace

MshContents read_msh_contents(std::string_view content, std::string_view name) {
  Cursor in(content, name);
  const Format format = find_format(in);
  return Sections(in, format).read();
}

sim::Mesh read_msh(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  return make_mesh(read_msh_contents(content, name), std::string(name), remarks);
}

}  // namespace app
