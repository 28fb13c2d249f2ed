#include "app/scene/scene_value.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "app/base/nearest.h"
#include "app/base/text.h"
#include "app/scene/value_text.h"

namespace app {
namespace {

[[noreturn]] void refuse(const std::string& right) {
  throw std::invalid_argument("must be " + right);
}

double number(const toml::node& node, const Form& form) {
  if (!node.is_number()) refuse(kind_text(form));
  const double x = node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
  if (!std::isfinite(x)) refuse("finite");
  if (!form.range.contains(x)) refuse(form.range.text());
  return x;
}

std::int64_t integer(const toml::node& node, const Form& form) {
  if (!node.is_integer()) refuse(kind_text(form));
  number(node, form);
  return *node.value<std::int64_t>();
}

std::string text(const toml::node& node, const Form& form) {
  if (!node.is_string()) refuse(kind_text(form));
  return *node.value<std::string>();
}

std::string name(const toml::node& node, const Form& form) {
  const std::string given = text(node, form);
  const auto bad = [](unsigned char c) { return c == ',' || c == '"' || c < 0x20 || c == 0x7F; };
  if (given.empty() || std::ranges::any_of(given, bad)) refuse(kind_text(form));
  return given;
}

std::string choice(const toml::node& node, const Form& form) {
  const std::string given = text(node, form);
  const std::vector<std::string_view> choices = form.choices();
  if (std::ranges::find(choices, given) == choices.end()) refuse(kind_text(form) + suggestion(given, choices));
  return given;
}

std::string axes(const toml::node& node, const Form& form) {
  const std::string given = text(node, form);
  for (const char c : given) {
    if (std::string_view("xyz").find(c) == std::string_view::npos || std::ranges::count(given, c) > 1) {
      refuse(kind_text(form));
    }
  }
  if (given.empty()) refuse(kind_text(form));
  return given;
}

// The entries of an array of least <= length <= most.
const toml::array& entries(const toml::node& node, const Form& form, std::size_t least, std::size_t most) {
  const toml::array* array = node.as_array();
  if (!array || array->size() < least || array->size() > most) refuse(kind_text(form));
  return *array;
}

std::vector<double> numbers(const toml::node& node, const Form& form, int least, int most) {
  std::vector<double> list;
  for (const toml::node& entry : entries(node, form, least, most)) {
    if (form.kind == Kind::integers && !entry.is_integer()) refuse(kind_text(form));
    list.push_back(number(entry, form));
  }
  return list;
}

std::vector<std::string> texts(const toml::node& node, const Form& form) {
  std::vector<std::string> list;
  for (const toml::node& entry : entries(node, form, form.size[0], form.size[1])) {
    if (!entry.is_string()) refuse(kind_text(form));
    list.push_back(*entry.value<std::string>());
  }
  return list;
}

// Two or three numbers; three are returned. `dimension` is how many there were, which must agree if it is known.
std::vector<double> point(const toml::node& node, const Form& form, int& dimension) {
  std::vector<double> x = numbers(node, form, 2, 3);
  const int size = static_cast<int>(x.size());
  if (dimension != 0 && size != dimension) refuse("points of the same number of coordinates");
  dimension = size;
  x.resize(3, 0.0);
  return x;
}

// The unit vector; one that is unit but for round-off is kept, bit by bit.
std::vector<double> unit(std::vector<double> x) {
  const double norm = std::hypot(x[0], x[1], x[2]);
  if (norm == 0) refuse("different from zero");
  if (std::abs(norm - 1) > 1e-15) {
    for (double& component : x) component /= norm;
  }
  return x;
}

std::vector<double> box(const toml::node& node, const Form& form, int& dimension) {
  const toml::array& corners = entries(node, form, 2, 2);
  std::vector<double> low = point(corners[0], form, dimension);
  const std::vector<double> high = point(corners[1], form, dimension);
  for (int i = 0; i < 3; ++i) {
    if (low[i] > high[i]) refuse("[low, high] with no coordinate of low above that of high");
  }
  low.insert(low.end(), high.begin(), high.end());
  return low;
}

// As many rows as columns.
std::vector<double> matrix(const toml::node& node, const Form& form, int& dimension) {
  std::vector<double> all;
  const toml::array& rows = entries(node, form, 2, 3);
  for (const toml::node& row : rows) {
    const auto size = static_cast<int>(rows.size());
    const std::vector<double> one = numbers(row, form, size, size);
    all.insert(all.end(), one.begin(), one.end());
  }
  dimension = static_cast<int>(rows.size());
  return all;
}

std::vector<double> points(const toml::node& node, const Form& form, int& dimension) {
  std::vector<double> all;
  for (const toml::node& entry : entries(node, form, 1, std::numeric_limits<std::size_t>::max())) {
    const std::vector<double> one = point(entry, form, dimension);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

std::vector<double> ball(const toml::node& node, const Form& form, int& dimension) {
  const toml::array& parts = entries(node, form, 2, 2);
  std::vector<double> numbers = point(parts[0], form, dimension);
  numbers.push_back(number(parts[1], form));
  if (numbers.back() <= 0) refuse("[centre, radius] with a radius > 0");
  return numbers;
}

Value value_of(const Form& form, const toml::node& node, int& dimension) {
  switch (form.kind) {
    case Kind::boolean:
      if (!node.is_boolean()) refuse(kind_text(form));
      return *node.value<bool>();
    case Kind::integer:
      return integer(node, form);
    case Kind::substeps:
      return node.is_string() && text(node, form) == "auto" ? std::int64_t{0} : integer(node, form);
    case Kind::number:
      return number(node, form);
    case Kind::joining:
      return node.is_boolean() ? (*node.value<bool>() ? 0.0 : -1.0) : number(node, form);
    case Kind::switch_or_text:
      return node.is_boolean() ? Value(*node.value<bool>()) : Value(text(node, form));
    case Kind::text:
      return text(node, form);
    case Kind::name:
      return name(node, form);
    case Kind::choice:
      return choice(node, form);
    case Kind::axes:
      return axes(node, form);
    case Kind::names:
      return texts(node, form);
    case Kind::integers:
    case Kind::numbers:
      return numbers(node, form, form.size[0], form.size[1]);
    case Kind::point:
      return point(node, form, dimension);
    case Kind::direction:
      return unit(point(node, form, dimension));
    case Kind::axis:
      return unit(numbers(node, form, 3, 3));
    case Kind::box:
      return box(node, form, dimension);
    case Kind::ball:
      return ball(node, form, dimension);
    case Kind::matrix:
      return matrix(node, form, dimension);
    case Kind::points:
      return points(node, form, dimension);
    case Kind::table:
    case Kind::list:
      break;
  }
  refuse(kind_text(form));
}

}  // namespace

std::string node_literal(const toml::node& node) {
  if (const toml::value<double>* number = node.as_floating_point()) return number_literal(number->get());
  if (const toml::value<std::string>* text = node.as_string()) return quoted_text(text->get());
  if (const toml::value<bool>* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (const toml::value<std::int64_t>* integer = node.as_integer()) return std::to_string(integer->get());
  std::string text;
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& entry : *array) text += (text.empty() ? "" : ", ") + node_literal(entry);
    return "[" + text + "]";
  }
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, entry] : *table) {
      text.append(text.empty() ? " " : ", ").append(name.str()).append(" = ").append(node_literal(entry));
    }
    return "{" + text + " }";
  }
  return "a date or time";
}

ScannedValue scan_value(const Form& form, const toml::node& node) {
  ScannedValue scan;
  scan.value = value_of(form, node, scan.dimension);
  return scan;
}

std::string node_text(const toml::node& node) {
  constexpr std::size_t longest = 60;
  std::string text = node_literal(node);
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

toml::table parsed(std::string_view text, const std::string& name) {
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const std::string what(error.description());
    const bool over_lines = what.find("inline table") != std::string::npos && what.find("'\\n'") != std::string::npos;
    throw SceneError(name + ":" + std::to_string(error.source().begin.line) + ": " + what +
                     (over_lines ? "; a table in braces stands on one line: join its lines, or write it as [body.mesh] "
                                   "with a line for each key"
                                 : ""));
  }
}

}  // namespace app
