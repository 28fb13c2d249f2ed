// The key table and a document, arranged for a panel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene/keys.h"

namespace app {

// "body.0.material.young" is the entry "young" in the group "material" of the section "body.0".
struct Entry {
  const Key* key;
  std::string path, name;
  std::optional<Value> value;  // none where the key is absent
};
struct Group {
  std::string name;   // empty: keys of the section itself
  bool open = false;  // at first
  std::vector<Entry> entries;
};
struct Section {
  std::string path, title;
  bool open = false;
  std::vector<Group> groups;
};

// Every key that the document has a place for, in the order of the table but for the groups of a body: what is changed
// most comes first.
std::vector<Section> sections(const Document& document);

}  // namespace app
