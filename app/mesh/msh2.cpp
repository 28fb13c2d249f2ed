#include "app/mesh/msh2.h"

#include <cstdlib>

namespace app {
namespace {

// The count of a section is text in binary files too, on a line of its own.
int read_count(MshFields& in, std::string_view what, std::size_t text_bytes_each, std::size_t binary_bytes_each) {
  const std::int64_t count = in.cursor().whole(what);
  if (in.binary()) in.cursor().rest_of_line();
  return in.cursor().checked_count(count, in.binary() ? binary_bytes_each : text_bytes_each, what);
}

// The tags and nodes of one element. The first tag is the physical group (0: none); a negative one means that the
// element is reversed in its group.
void read_element(MshFields& in, const MshType& type, int tag_count, MshContents& contents) {
  std::vector<int> physical;
  for (int i = 0; i < tag_count; ++i) {
    const int tag = in.tag("a tag of an element");
    if (i == 0 && tag != 0) physical.push_back(std::abs(tag));
  }
  MshBlock& block = contents.block(type, physical);
  for (int local = 0; local < type.nodes; ++local) {
    add_node(in.cursor(), contents.tags, in.tag("a node of an element"), local, block);
  }
}

void read_text_elements(MshFields& in, int count, MshContents& contents) {
  for (int i = 0; i < count; ++i) {
    in.tag("the number of an element");
    const MshType& type = msh_type(in.cursor(), in.tag("the type of an element"));
    const int tag_count = in.cursor().checked_count(in.tag("the number of tags"), 2, "the number of tags");
    read_element(in, type, tag_count, contents);
  }
}

// In binary, elements follow a header that says type and number of tags for several of them.
void read_binary_elements(MshFields& in, int count, MshContents& contents) {
  for (int done = 0; done < count;) {
    const MshType& type = msh_type(in.cursor(), in.tag("the type of elements"));
    const int following = in.integer("the number of elements that follow", 1, count - done);
    const int tag_count = in.cursor().checked_count(in.tag("the number of tags"), 4, "the number of tags");
    for (int i = 0; i < following; ++i) {
      in.tag("the number of an element");
      read_element(in, type, tag_count, contents);
    }
    done += following;
  }
}

}  // namespace

void read_msh2_nodes(MshFields& in, MshContents& contents) {
  const int count = read_count(in, "the number of nodes", 8, 28);
  std::vector<std::int64_t> tags;
  tags.reserve(static_cast<std::size_t>(count));
  contents.coordinates.reserve(3 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    tags.push_back(in.tag("the number of a node"));
    for (const char* axis : {"x", "y", "z"}) contents.coordinates.push_back(in.real(axis));
  }
  number_nodes(in.cursor(), tags, contents);
}

void read_msh2_elements(MshFields& in, MshContents& contents) {
  const int count = read_count(in, "the number of elements", 8, 8);
  if (in.binary()) {
    read_binary_elements(in, count, contents);
  } else {
    read_text_elements(in, count, contents);
  }
}

}  // namespace app
