#include "app/session/session_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <initializer_list>

#include "app/base/nearest.h"
#include "app/mesh/contents.h"
#include "app/mesh/error.h"
#include "app/scene/scene_error.h"
#include "app/scene/scene_value.h"

namespace app {
namespace {

// A table of the file, whose keys are asked for by name; errors say the line.
class Table {
 public:
  Table(const toml::table& table, const std::string& file) : table_(table), file_(file) {}

  std::string place(const toml::source_region& source) const {
    return file_ + ":" + std::to_string(std::max<std::size_t>(1, source.begin.line));
  }
  std::string place() const { return place(table_.source()); }
  [[noreturn]] void refuse(const toml::source_region& source, const std::string& why) const {
    throw SceneError(place(source) + ": " + why);
  }

  bool has(std::string_view key) const { return table_.contains(key); }
  const toml::node& node(std::string_view key) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) refuse(table_.source(), "'" + std::string(key) + "' is missing");
    return *node;
  }
  template <class T>
  T value(std::string_view key, const Form& form) const {
    try {
      return std::get<T>(scan_value(form, node(key)).value);
    } catch (const std::invalid_argument& error) {
      wrong(key, error.what());
    }
  }
  std::string text(std::string_view key) const { return value<std::string>(key, Kind::text); }
  std::int64_t count(std::string_view key) const {
    return value<std::int64_t>(key, Form(Kind::integer, "", {.low = 0}));
  }
  double number(std::string_view key) const { return value<double>(key, Kind::number); }
  sim::Vec3 point(std::string_view key) const { return sim::Vec3(value<std::vector<double>>(key, Kind::point).data()); }
  const toml::array& array(std::string_view key) const {
    if (node(key).as_array() == nullptr) wrong(key, "must be a list");
    return *node(key).as_array();
  }
  const toml::table& table(std::string_view key) const {
    if (node(key).as_table() == nullptr) wrong(key, "must be a table");
    return *node(key).as_table();
  }

  void allow(std::initializer_list<std::string_view> known) const {
    for (const auto& [name, value] : table_) {
      if (std::ranges::find(known, name.str()) != known.end()) continue;
      const std::string_view meant = nearest(name.str(), {known.begin(), known.size()});
      std::string message = "unknown key '" + std::string(name.str()) + "'";
      if (!meant.empty()) message += ": did you mean '" + std::string(meant) + "'?";
      refuse(value.source(), message);
    }
  }

 private:
  [[noreturn]] void wrong(std::string_view key, const std::string& why) const {
    refuse(node(key).source(), std::string(key) + " = " + node_text(node(key)) + ": " + why);
  }

  const toml::table& table_;
  const std::string& file_;
};

Input read_set(const Table& table) {
  table.allow({"step", "do", "key", "value"});
  return SetKey{table.text("key"), node_literal(table.node("value"))};
}

Input read_camera(const Table& table) {
  table.allow({"step", "do", "eye", "target", "height"});
  MoveCamera move;
  if (table.has("eye")) move.eye = table.point("eye");
  if (table.has("target")) move.target = table.point("target");
  if (table.has("height")) move.height = table.number("height");
  return move;
}

Input read_pull(const Table& table) {
  table.allow({"step", "do", "body", "at", "target"});
  return Pull{table.text("body"), table.point("at"), table.point("target")};
}

Input read_pull_to(const Table& table) {
  table.allow({"step", "do", "target"});
  return PullTo{table.point("target")};
}

template <class Kind>
Input read_plain(const Table& table) {
  table.allow({"step", "do"});
  return Kind{};
}

struct Reading {
  std::string_view name;
  Input (*read)(const Table&);
};
constexpr std::array<Reading, 8> readings = {{{"set", read_set},
                                              {"camera", read_camera},
                                              {"pull", read_pull},
                                              {"pull-to", read_pull_to},
                                              {"release", read_plain<Release>},
                                              {"back", read_plain<StepBack>},
                                              {"reset", read_plain<Reset>},
                                              {"restart", read_plain<Restart>}}};

Input read_input(const Table& table) {
  const auto names = [] {
    std::vector<std::string_view> all;
    for (const Reading& reading : readings) all.push_back(reading.name);
    return all;
  };
  const auto what = table.value<std::string>("do", Form(Kind::choice).of(names));
  return std::ranges::find(readings, what, &Reading::name)->read(table);
}

void read_inputs(const Table& root, const std::string& file, SessionFile& session) {
  for (const toml::node& node : root.array("input")) {
    if (node.as_table() == nullptr) root.refuse(node.source(), "input must be a list of tables");
    const Table table(*node.as_table(), file);
    const std::int64_t step = table.count("step");
    if (step < session.steps) {
      table.refuse(table.node("step").source(),
                   "step = " + std::to_string(step) + ": must not be before the input above it");
    }
    session.steps = step;
    session.inputs.push_back({{step, read_input(table)}, table.place()});
  }
}

void read_end(const Table& root, const std::string& file, SessionFile& session) {
  const Table end(root.table("end"), file);
  end.allow({"steps", "state_hash"});
  if (end.count("steps") < session.steps) {
    end.refuse(end.node("steps").source(), "steps: must not be before the last input");
  }
  session.steps = end.count("steps");
  session.state_hash = end.text("state_hash");
}

void read_set_options(const Table& root, SessionFile& session) {
  for (const toml::node& node : root.array("set")) {
    const std::string text = node.value_or(std::string());
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) root.refuse(node.source(), "set: must be a list of \"KEY=VALUE\"");
    session.overrides.push_back(
        {text.substr(0, equals), text.substr(equals + 1), root.place(node.source()) + ": " + text});
  }
}

}  // namespace

SessionFile read_session(const std::filesystem::path& path) {
  const std::string file = path.string();
  toml::table contents;
  try {
    contents = parsed(read_contents(path), file);
  } catch (const FileError& error) {
    throw SceneError(error.what());
  }
  const Table root(contents, file);
  root.allow({"scene", "settings", "set", "input", "end"});
  SessionFile session;
  root.text("scene");
  if (root.has("settings")) session.settings = root.text("settings");
  if (root.has("set")) read_set_options(root, session);
  if (root.has("input")) read_inputs(root, file, session);
  if (root.has("end")) read_end(root, file, session);
  return session;
}

}  // namespace app
