// The tags of an XML file, one after the other: as much of XML as data files have.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "app/mesh/cursor.h"

namespace app {

struct XmlTag {
  std::string name;  // "/Points" of an end; empty: the file is finished
  std::map<std::string, std::string> attributes;
  bool empty = false;       // <name .../>
  std::size_t text_at = 0;  // place in the file of
  std::string_view text;    // what follows up to the next tag

  // Empty when the tag does not have it.
  std::string attribute(const std::string& name) const;
};

// Declarations and comments are passed over. Fails at what is no tag.
XmlTag next_tag(Cursor& in);

}  // namespace app
