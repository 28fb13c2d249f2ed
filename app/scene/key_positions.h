// Where the lists of a document have a key.
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include "app/scene/exhibits.h"
#include "app/scene/keys.h"

namespace app {

// Calls visit(indices) for every position that the lists of the document give to the key; `rest` is what remains of
// its path after the lists that the first `depth` indices count in.
template <class Visit>
void for_each_position(const Document& document, const Key& key, std::string_view rest, Indices indices, int depth,
                       const Visit& visit) {
  const std::size_t bracket = rest.find("[]");
  if (bracket == std::string_view::npos) return visit(indices);
  rest.remove_prefix(bracket + 2);
  const Key& list = *find_key(key.path.substr(0, key.path.size() - rest.size()));
  const std::int64_t count = std::get<std::int64_t>(*list.binding.get(document, indices));
  for (int i = 0; i < count; ++i) {
    indices[depth] = i;
    for_each_position(document, key, rest, indices, depth + 1, visit);
  }
}

// An exhibit has only the keys of its kind.
template <class Visit>
void for_each_position(const Document& document, const Key& key, const Visit& visit) {
  const bool of_exhibit = parent(key.path) == "exhibit[]";
  for_each_position(document, key, key.path, {}, 0, [&](const Indices& indices) {
    const auto k = static_cast<std::size_t>(indices[0]);
    if (!of_exhibit || exhibit_has(document.exhibits[k].kind, last_name(key.path))) visit(indices);
  });
}

}  // namespace app
