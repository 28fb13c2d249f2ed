#include "app/scene/scene_text.h"

#include <algorithm>
#include <array>

#include "app/base/text.h"
#include "app/scene/key_positions.h"
#include "app/scene/value_text.h"

namespace app {
namespace {

// What a text is made of: a value (as text), or named entries of a table, or unnamed entries of an array.
struct Node {
  enum class Type { value, table, array } type = Type::value;
  std::string name = {};
  std::string text = {};
  std::vector<Node> entries = {};
};

bool is_index(std::string_view name) {
  return name.find_first_not_of("0123456789") == std::string_view::npos;
}

// Where a new entry goes: those of arrays in the order of their numbers, others last.
std::vector<Node>::iterator place_of(std::vector<Node>& entries, std::string_view name) {
  if (!is_index(name)) return entries.end();
  return std::ranges::find_if(entries, [&](const Node& entry) {
    return entry.name.size() != name.size() ? entry.name.size() > name.size() : entry.name > name;
  });
}

// Adds the value at the path, with the tables and arrays on the way. Entries of arrays come in order.
void put(Node& root, std::string_view path, std::string text) {
  Node* node = &root;
  while (true) {
    const std::string_view name = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(path.size(), name.size() + 1));
    auto found = std::ranges::find(node->entries, name, &Node::name);
    if (found == node->entries.end())
      found = node->entries.insert(place_of(node->entries, name), {.name = std::string(name)});
    node = &*found;
    if (path.empty()) break;
    node->type = is_index(path.substr(0, path.find('.'))) ? Node::Type::array : Node::Type::table;
  }
  node->text = std::move(text);
}

// An empty folder is the current one.
std::string relative_path(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const std::filesystem::path base = std::filesystem::absolute(folder.empty() ? "." : folder);
  return std::filesystem::absolute(file)
      .lexically_normal()
      .lexically_proximate(base.lexically_normal())
      .generic_string();
}

bool names_file(std::string_view path) {
  constexpr std::array<std::string_view, 6> all = {"body[].mesh.file",  "body[].mesh.surface", "body[].mesh.skin",
                                                   "body[].start.file", "body[].basis.from",   "obstacle[].mesh.file"};
  return std::ranges::find(all, path) != all.end();
}

Node filled(const Document& document, const std::filesystem::path& folder) {
  const int dimension = document.scene.dimension;
  Node root = {.type = Node::Type::table};
  for (const Key& key : keys()) {
    if (key.kind == Kind::table || key.kind == Kind::list) continue;
    if (key.dimension != 0 && key.dimension != dimension) continue;
    for_each_position(document, key, [&](const Indices& indices) {
      std::optional<Value> value = key.binding.get(document, indices);
      if (!value) return;
      if (names_file(key.path) && std::holds_alternative<std::string>(*value))
        value = relative_path(std::get<std::string>(*value), folder);
      if (key.path == "exhibit[].problem")
        value = relative_path(document.folder / std::get<std::string>(*value), folder);
      put(root, path_at(key.path, indices), value_text(key, *value, dimension));
    });
  }
  return root;
}

// Everything on one line; `equals` stands between name and value: " = " in TOML, ": " in JSON.
std::string line(const Node& node, bool json) {
  if (node.type == Node::Type::value) return node.text;
  const bool table = node.type == Node::Type::table;
  std::string text = table ? "{ " : "[";
  for (const Node& entry : node.entries) {
    if (&entry != &node.entries.front()) text += ", ";
    if (table) text += json ? quoted_text(entry.name) + ": " : entry.name + " = ";
    text += line(entry, json);
  }
  return text + (table ? " }" : "]");
}

std::string lines(const Node& table) {
  std::string text;
  for (const Node& entry : table.entries) text += entry.name + " = " + line(entry, false) + "\n";
  return text;
}

}  // namespace

std::string scene_toml(const Document& document, const std::filesystem::path& folder) {
  std::string text;
  for (const Node& part : filled(document, folder).entries) {
    switch (part.type) {
      case Node::Type::value:
        text += part.name + " = " + part.text + "\n";
        break;
      case Node::Type::table:
        text += "\n[" + part.name + "]\n" + lines(part);
        break;
      case Node::Type::array:
        for (const Node& entry : part.entries) text += "\n[[" + part.name + "]]\n" + lines(entry);
        break;
    }
  }
  return text;
}

std::string scene_json(const Document& document, const std::filesystem::path& folder) {
  return line(filled(document, folder), true);
}

std::string list_toml(const Document& document, std::string_view list, int left_out) {
  Node root = filled(document, {});
  const auto found = std::ranges::find(root.entries, list, &Node::name);
  if (found == root.entries.end()) return "[]";
  found->entries.erase(found->entries.begin() + left_out);
  return line(*found, false);
}

}  // namespace app
