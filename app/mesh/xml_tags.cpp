#include "app/mesh/xml_tags.h"

#include <algorithm>

namespace app {
namespace {

// name="value" or name='value', as many as there are.
void read_attributes(const Cursor& in, std::string_view text, XmlTag& tag) {
  for (;;) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == text.npos) return;
    const std::size_t equals = text.find('=', start);
    const std::size_t open = equals == text.npos ? text.npos : text.find_first_of("\"'", equals);
    const std::size_t close = open == text.npos ? text.npos : text.find(text[open], open + 1);
    if (close == text.npos) in.fail("an attribute of the tag " + quote(tag.name) + " is not name=\"value\"");
    std::string_view name = text.substr(start, equals - start);
    name = name.substr(0, name.find_first_of(" \t\r\n"));
    tag.attributes[std::string(name)] = text.substr(open + 1, close - open - 1);
    text.remove_prefix(close + 1);
  }
}

}  // namespace

std::string XmlTag::attribute(const std::string& name) const {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::string() : found->second;
}

XmlTag next_tag(Cursor& in) {
  for (;;) {
    if (in.finished()) return {};
    in.take("<", "a tag");
    if (in.starts_with("!--")) {
      if (!in.skip_past("-->")) in.fail("a comment has no end");
      continue;
    }
    std::string_view inside = in.up_to('>');
    in.take(">", "the end of a tag");
    if (inside.starts_with('?') || inside.starts_with('!')) continue;
    XmlTag tag;
    tag.empty = inside.ends_with('/');
    if (tag.empty) inside.remove_suffix(1);
    const std::size_t end = std::min(inside.find_first_of(" \t\r\n"), inside.size());
    tag.name = inside.substr(0, end);
    read_attributes(in, inside.substr(end), tag);
    tag.text_at = in.position();
    tag.text = in.up_to('<');
    return tag;
  }
}

}  // namespace app
