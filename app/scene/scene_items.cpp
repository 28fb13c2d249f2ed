#include "app/scene/scene_items.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "app/base/nearest.h"
#include "app/base/shipped.h"
#include "app/scene/scene_value.h"
#include "sim/mesh/input_error.h"

namespace app {
namespace {

std::string joined(const std::string& path, std::string_view name) {
  return path.empty() ? std::string(name) : path + "." + std::string(name);
}

// Where the walk through a source is.
struct Cursor {
  std::string pattern;  // "body[].pin"
  std::string path;     // "body.0.pin"
  Indices indices = {};
  int depth = 0;  // lists entered

  Cursor child(std::string_view name) const { return {joined(pattern, name), joined(path, name), indices, depth}; }
  Cursor entry(int index) const {
    Cursor next = {pattern + "[]", joined(path, std::to_string(index)), indices, depth + 1};
    next.indices[depth] = index;
    return next;
  }
  const Key* value() const { return find_key(pattern); }
  const Key* list() const { return find_key(pattern + "[]"); }
};

// Collects the items of one source.
class Reader {
 public:
  // `name` is the file; with `whole` it is an override, which has no lines.
  Reader(std::string name, bool whole) : name_(std::move(name)), whole_(whole) {}

  void read_value_at(const Cursor& at, const toml::node& node);
  void read_entries(const Cursor& at, const toml::node& node);
  // Follows the names of an override's key to where its value belongs.
  void read_path(std::string_view path, const toml::node& node);

  // Reads something; what is refused there is kept as a mistake, and the reading goes on after it.
  template <class Read>
  void attempt(const Read& read) {
    try {
      read();
    } catch (Mistake& mistake) {
      layer_.mistakes.push_back(std::move(mistake));
    }
  }

  Layer take() { return std::move(layer_); }

 private:
  Place place(const toml::source_region& source, std::string text = {}) const {
    if (whole_) return {name_, std::move(text)};
    const auto line = static_cast<int>(source.begin.line), column = static_cast<int>(source.begin.column);
    return {name_ + ":" + std::to_string(line), std::move(text), line, column};
  }
  // These throw a Mistake.
  [[noreturn]] void refuse(const Cursor& at, const toml::node& node, const std::string& why) const;
  [[noreturn]] void refuse_name(const Cursor& at, std::string_view name, const toml::source_region& source) const;
  int index(const Cursor& list, std::string_view name, const toml::source_region& source) const;
  void read_list(const Cursor& at, const toml::node& node);
  void read_entry(const Cursor& at, const toml::node& node);
  void add(const Cursor& at, const Key& key, Value value, Place place, int dimension = 0) {
    layer_.items.push_back({at.path, &key, at.indices, std::move(value), dimension, std::move(place)});
  }

  std::string name_;
  bool whole_;
  Layer layer_;
};

void Reader::refuse(const Cursor& at, const toml::node& node, const std::string& why) const {
  throw located(sim::InputError(at.path, why), {{at.path, place(node.source(), node_text(node))}});
}

void Reader::refuse_name(const Cursor& at, std::string_view name, const toml::source_region& source) const {
  std::vector<std::string_view> known;
  for (const Key& key : keys()) {
    if (parent(key.path) == at.pattern) known.push_back(last_name(key.path));
  }
  std::string message = place(source).where + ": unknown key '" + joined(at.path, name) + "'";
  const std::string_view meant = nearest(name, known);
  const auto elsewhere = std::ranges::find(keys(), name, [](const Key& key) { return last_name(key.path); });
  if (!meant.empty()) {
    message.append(": did you mean '").append(meant).append("'?");
  } else if (elsewhere != keys().end()) {
    message.append(": did you mean '").append(elsewhere->path).append("'?");
  } else {
    for (const std::string_view other : known)
      message.append(other == known[0] ? ": known here are " : ", ").append(other);
  }
  throw Mistake{joined(at.path, meant.empty() ? name : meant), place(source), message};
}

int Reader::index(const Cursor& list, std::string_view name, const toml::source_region& source) const {
  const int index = index_of(name);
  if (index < 0) {
    throw Mistake{list.path, place(source),
                  place(source).where + ": '" + joined(list.path, name) + "': " + list.path +
                      " is a list: its entries are numbered from 0, as in '" + list.path + ".0'"};
  }
  return index;
}

void Reader::read_value_at(const Cursor& at, const toml::node& node) {
  if (at.list()) return read_list(at, node);
  const Key& key = *at.value();
  if (key.kind == Kind::table) {
    add(at, key, {}, place(node.source()));
    return read_entries(at, node);
  }
  try {
    ScannedValue scan = scan_value(key, node);
    add(at, key, std::move(scan.value), place(node.source(), node_text(node)), scan.dimension);
  } catch (const std::invalid_argument& wrong) {
    refuse(at, node, wrong.what());
  }
}

void Reader::read_list(const Cursor& at, const toml::node& node) {
  if (const toml::array* array = node.as_array()) {
    layer_.lists.push_back(at.path);
    for (std::size_t i = 0; i < array->size(); ++i) {
      attempt([&] { read_entry(at.entry(static_cast<int>(i)), (*array)[i]); });
    }
  } else if (const toml::table* table = node.as_table()) {
    for (const auto& [name, entry] : *table) {
      attempt([&] { read_entry(at.entry(index(at, name.str(), name.source())), entry); });
    }
  } else {
    refuse(at, node, "must be a list of tables");
  }
}

void Reader::read_entry(const Cursor& at, const toml::node& node) {
  add(at, *at.value(), std::int64_t{at.indices[at.depth - 1]}, place(node.source()));
  read_entries(at, node);
}

void Reader::read_entries(const Cursor& at, const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, value] : *table) {
      const Cursor next = at.child(name.str());
      const bool unknown = name.str().find_first_of(".[]") != std::string_view::npos || (!next.value() && !next.list());
      attempt([&] { unknown ? refuse_name(at, name.str(), name.source()) : read_value_at(next, value); });
    }
    return;
  }
  const toml::array* array = node.as_array();
  if (!array || !at.child("0").value()) refuse(at, node, "must be a table");
  for (std::size_t i = 0; i < array->size(); ++i) {
    const Cursor next = at.child(std::to_string(i));
    if (!next.value()) refuse(at, node, "has too many entries");
    attempt([&] { read_value_at(next, (*array)[i]); });
  }
}

void Reader::read_path(std::string_view path, const toml::node& node) {
  Cursor at;
  while (!path.empty()) {
    const std::string_view name = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(path.size(), name.size() + 1));
    if (at.list()) {
      at = at.entry(index(at, name, node.source()));
      add(at, *at.value(), std::int64_t{at.indices[at.depth - 1]}, place(node.source()));
      continue;
    }
    const Cursor next = at.child(name);
    if (name.find_first_of("[]") != std::string_view::npos || (!next.value() && !next.list())) {
      refuse_name(at, name, node.source());
    }
    at = next;
  }
  if (at.pattern.empty() || at.pattern.ends_with("[]")) return read_entries(at, node);
  read_value_at(at, node);
}

// Of the scenes that come with the program, the one whose name was misspelt.
std::string meant_scene(const std::filesystem::path& given) {
  const std::vector<std::string> shipped = shipped_scenes();
  const std::vector<std::string_view> names(shipped.begin(), shipped.end());
  return suggestion(given.string(), names);
}

bool below(std::string_view path, std::string_view ancestor) {
  return path.size() > ancestor.size() && path.starts_with(ancestor) && path[ancestor.size()] == '.';
}

// Drops what the new item excludes: the other keys of its alternatives.
void drop_excluded(std::vector<Item>& items, const Item& item) {
  for (const Alternatives& group : alternatives()) {
    const std::string_view name = last_name(item.key->path);
    if (parent(item.key->path) != group.table || std::ranges::find(group.names, name) == group.names.end()) continue;
    const std::string table(parent(item.path));
    for (const std::string_view other : group.names) {
      const std::string path = joined(table, other);
      if (other != name)
        std::erase_if(items, [&](const Item& old) { return old.path == path || below(old.path, path); });
    }
  }
}

}  // namespace

Layer read_layer(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::exists(file)) throw SceneError(file.string() + ": there is no such file" + meant_scene(file));
  if (std::filesystem::is_directory(file)) throw SceneError(file.string() + ": is a folder, not a scene file");
  std::ostringstream text;
  if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (!in || !text) throw SceneError(file.string() + ": cannot be read");
  return read_layer(text.str(), file.string());
}

Layer read_layer(std::string_view text, const std::string& name) {
  Reader reader(name, false);
  reader.read_entries({}, parsed(text, name));
  return reader.take();
}

Layer read_layer(const Override& override) {
  toml::table table;
  try {
    table = toml::parse("value = " + override.value);
  } catch (const toml::parse_error&) {
    // Not TOML: a bare string, as in --set time.integrator=backward-euler.
  }
  if (table.size() != 1 || !table.contains("value")) table = toml::table{{"value", override.value}};
  Reader reader(override.origin, true);
  reader.attempt([&] { reader.read_path(override.key, *table.get("value")); });
  return reader.take();
}

void lay_over(Layer& lower, Layer layer) {
  std::vector<Item>& items = lower.items;
  std::ranges::move(layer.mistakes, std::back_inserter(lower.mistakes));
  if (items.empty()) {
    items = std::move(layer.items);
    return;
  }
  for (const std::string& list : layer.lists)
    std::erase_if(items, [&](const Item& old) { return below(old.path, list); });
  for (const Item& item : layer.items) drop_excluded(items, item);
  for (Item& item : layer.items) {
    const auto found = std::ranges::find(items, item.path, &Item::path);
    if (found == items.end()) {
      items.push_back(std::move(item));
    } else if (item.key->kind != Kind::table && item.key->kind != Kind::list) {
      *found = std::move(item);
    }
  }
}

}  // namespace app
