#include "app/scene/keys.h"

#include <algorithm>
#include <charconv>

#include "app/base/number_text.h"
#include "app/scene/keys/binding.h"

namespace app {
namespace {

std::vector<Key> make_keys() {
  std::vector<Key> table;
  for (const auto part :
       {time_keys, solver_keys, world_keys, body_keys, start_keys, basis_keys, mesh_keys, material_keys, pin_keys,
        load_keys, obstacle_keys, contact_keys, spring_keys, probe_keys, camera_keys, look_keys, exhibit_keys}) {
    append(table, part());
  }
  for (Key& key : table) {
    const auto holder = std::ranges::find(table, parent(key.path), &Key::path);
    if (!key.effect) key.effect = holder == table.end() ? Effect::motion : holder->effect;
  }
  return table;
}

std::string choice_text(const std::vector<std::string_view>& choices) {
  std::string text;
  for (const std::string_view choice : choices) {
    text.append(text.empty() ? "one of \"" : ", \"").append(choice).append("\"");
  }
  return text;
}

std::string list_kind_text(const Form& form, std::string_view what) {
  const auto [least, most] = form.size;
  const std::string count = least == most
                                ? std::to_string(most)
                                : std::to_string(least) + (most > least + 1 ? " to " : " or ") + std::to_string(most);
  return "a list of " + count + " " + std::string(what);
}

}  // namespace

const std::vector<Key>& keys() {
  static const std::vector<Key> table = make_keys();
  return table;
}

const std::vector<Alternatives>& alternatives() {
  static const std::vector<Alternatives> table = {
      {"time", {"substeps", "step"}, false},
      {"body[].mesh", {"box", "rectangle", "sheet", "file", "surface"}, true},
      {"body[].pin[]", {"box", "sphere", "group"}, true},
      {"body[].traction[]", {"box", "sphere", "group"}, true},
      {"body[].pressure[]", {"box", "sphere", "group"}, false},
      {"body[].start", {"nodes", "file"}, false},
      {"obstacle[]", {"plane", "sphere", "box", "mesh"}, true},
      {"obstacle[].mesh", {"box", "rectangle", "sheet", "file"}, true},
  };
  return table;
}

bool Range::contains(double x) const {
  return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
}

std::string Range::text() const {
  const bool has_low = low > -std::numeric_limits<double>::infinity();
  const bool has_high = high < std::numeric_limits<double>::infinity();
  std::string text;
  if (has_low && has_high) {
    text = low_open ? "in (" : "in [";
    append_number(text, low);
    text += ", ";
    append_number(text, high);
    text += high_open ? ")" : "]";
  } else if (has_low) {
    text = low_open ? "> " : ">= ";
    append_number(text, low);
  } else if (has_high) {
    text = high_open ? "< " : "<= ";
    append_number(text, high);
  }
  return text;
}

int index_of(std::string_view name) {
  int index = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  return error == std::errc{} && end == name.data() + name.size() ? std::max(index, -1) : -1;
}

const Key* find_key(std::string_view pattern) {
  const auto found = std::ranges::find(keys(), pattern, &Key::path);
  return found == keys().end() ? nullptr : &*found;
}

const Key* find_key_at(std::string_view path, Indices& indices) {
  std::string pattern;
  std::size_t depth = 0;
  while (!path.empty()) {
    const std::string_view name = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(path.size(), name.size() + 1));
    const int index = index_of(name);
    if (index >= 0 && find_key(pattern + "[]") && depth < indices.size()) {
      pattern += "[]";
      indices[depth++] = index;
    } else {
      if (!pattern.empty()) pattern += '.';
      pattern += name;
    }
  }
  return find_key(pattern);
}

std::string path_at(std::string_view pattern, const Indices& indices) {
  std::string path;
  std::size_t depth = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '[') {
      path += '.' + std::to_string(indices[depth++]);
      ++i;
    } else {
      path += pattern[i];
    }
  }
  return path;
}

std::string_view parent(std::string_view pattern) {
  const std::size_t dot = pattern.rfind('.');
  return dot == std::string_view::npos ? std::string_view{} : pattern.substr(0, dot);
}

std::string_view last_name(std::string_view pattern) {
  pattern.remove_prefix(pattern.rfind('.') + 1);
  if (pattern.ends_with("[]")) pattern.remove_suffix(2);
  return pattern;
}

std::string kind_text(const Form& form) {
  // Points have two numbers in a plane scene, unless the key is of 3D scenes only.
  const auto points = [&](const std::string& space, const std::string& plane) {
    return form.dimension == 3 ? space : space + ", in 2D " + plane;
  };
  switch (form.kind) {
    case Kind::table:
      return "a table";
    case Kind::list:
      return "a list";
    case Kind::boolean:
      return "true or false";
    case Kind::integer:
      return "an integer";
    case Kind::substeps:
      return "an integer or \"auto\"";
    case Kind::joining:
      return "a number or true";
    case Kind::switch_or_text:
      return "true or a string";
    case Kind::number:
      return "a number";
    case Kind::text:
      return "a string";
    case Kind::name:
      return "a string without comma, quote or line end, not empty";
    case Kind::choice:
      return choice_text(form.choices());
    case Kind::axes:
      return "a string of some of x, y, z";
    case Kind::names:
      return list_kind_text(form, "strings");
    case Kind::integers:
      return list_kind_text(form, "integers");
    case Kind::numbers:
      return list_kind_text(form, "numbers");
    case Kind::point:
      return points("a point [x, y, z]", "[x, y]");
    case Kind::direction:
      return points("a direction [x, y, z]", "[x, y]");
    case Kind::axis:
      return "an axis [x, y, z]";
    case Kind::box:
      return points("a box [[x, y, z], [x, y, z]]", "[[x, y], [x, y]]");
    case Kind::ball:
      return points("a ball [[x, y, z], radius]", "[[x, y], radius]");
    case Kind::matrix:
      return points("three rows of three numbers", "two rows of two");
    case Kind::points:
      return points("a list of points [[x, y, z], ...]", "[[x, y], ...]");
  }
  return {};
}

Document blank_document() {
  Document document;
  for (const Key& key : keys()) {
    if (key.kind == Kind::list) key.binding.set(document, {}, std::int64_t{1});
  }
  // Meshes that are there: others stand nowhere.
  for (MeshSpec& mesh : document.meshes) mesh.source = MeshSource::file;
  for (ObstacleMesh& mesh : document.obstacle_meshes) mesh.spec.source = MeshSource::file;
  return document;
}

}  // namespace app
