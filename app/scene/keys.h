// The table of keys: all that a scene file may say, one entry per key, with unit, range, default, meaning and the
// field that it fills. Checks, dumps, the reference in app/scene/README.md and the panel are made from it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/scene/document.h"

namespace app {

enum class Kind {
  table,           // holds other keys; no value
  list,            // "body[]": an entry of a list; the value of the list is its length
  boolean,         // bool
  integer,         // std::int64_t
  substeps,        // integer, or "auto" = 0
  number,          // double
  joining,         // a distance, true = 0 or false = -1: double
  switch_or_text,  // bool or std::string
  text,            // std::string
  name,            // text that can head a column: not empty, no comma, quote or control character
  choice,          // text, one of choices()
  axes,            // text, some of x y z
  names,           // a list of texts
  integers,        // a list of numbers
  numbers,         // a list of numbers
  point,           // as many numbers as the scene has dimensions; the value has 3, the missing one is 0
  direction,       // a point other than 0, made unit
  axis,            // three numbers in 2D too, made unit; in a 2D scene +-z
  box,             // [low, high], two points; the value has 6 numbers
  ball,            // [centre, radius]; the value has 4 numbers
  matrix,          // rows of as many numbers as the scene has dimensions; the value has them row by row
  points,          // a list of points, as many as there are; the value has 3 numbers for each
};

using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, std::vector<std::string>>;

// Positions in the lists along a path, outermost first: body.2.pin.1.axes -> {2, 1, 0}.
using Indices = std::array<int, 3>;

// What a number may be (every number of a list).
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;  // the end itself is excluded

  bool contains(double x) const;
  std::string text() const;  // "> 0", "in (-1, 0.5)"; empty when everything is allowed
};

// How a key meets the document.
struct Binding {
  // The value of the key; none where an optional key is absent. For a list, its length.
  std::optional<Value> (*get)(const Document&, const Indices&) = nullptr;
  // Stores a checked value. For a list, makes it so long.
  void (*set)(Document&, const Indices&, const Value&) = nullptr;
};

// What a change of a key does to a run that is under way.
enum class Effect {
  look,     // only the picture changes
  motion,   // the run goes on with it
  start,    // the run goes on; it tells at the next reset
  restart,  // not while bodies move: it waits for the restart
};

// What a key accepts and what its value means: Form(Kind::number, "m", above(0)).only_in(3).
struct Form {
  Form(Kind kind, std::string_view unit = {}, const Range& range = {}) : kind(kind), unit(unit), range(range) {}

  Form& of(std::vector<std::string_view> (*names)()) { return choices = names, *this; }
  Form& of_size(int least, int most) { return size = {least, most}, *this; }
  Form& needed() { return required = true, *this; }
  Form& only_in(int scene) { return dimension = scene, *this; }
  Form& otherwise(std::string_view holds) { return absent = holds, *this; }
  Form& tells(Effect how) { return effect = how, *this; }

  Kind kind;
  std::string_view unit;  // SI; empty: none
  Range range;
  std::array<int, 2> size = {2, 3};  // least and greatest length of numbers, integers and names
  std::vector<std::string_view> (*choices)() = nullptr;
  bool required = false;         // wherever the table that holds it is present
  int dimension = 0;             // 2 or 3: only in such a scene; 0: in both
  std::string_view absent = {};  // what holds without the key, where that is not simply the default value
  std::optional<Effect> effect;  // in keys() every key has one: what it does not say is that of the table that holds it
};

struct Key : Form {
  Key(std::string_view path, const Form& form, const Binding& binding, std::string_view meaning)
      : Form(form), path(path), binding(binding), meaning(meaning) {}

  std::string path;  // "body[].material.young"; [] marks a list
  Binding binding;
  std::string_view meaning;
};

// Keys of which one table may hold one at most, or must hold exactly one.
struct Alternatives {
  std::string_view table;
  std::vector<std::string_view> names;
  bool required;
};

// Parents come before what they hold, and a key after those that its own meaning depends on.
const std::vector<Key>& keys();
const std::vector<Alternatives>& alternatives();

// The entry of a pattern such as "body[].name"; nullptr when there is none.
const Key* find_key(std::string_view pattern);

// The entry and the indices of a path such as "body.0.name"; nullptr when there is none.
const Key* find_key_at(std::string_view path, Indices& indices);

// The number that a name of a path spells, or -1: "12" -> 12.
int index_of(std::string_view name);

// The path that a pattern has at these indices: "body[].name", {2} -> "body.2.name".
std::string path_at(std::string_view pattern, const Indices& indices);

// The pattern without its last name: "body[].name" -> "body[]".
std::string_view parent(std::string_view pattern);
// The last name: "name"; of a list without its [].
std::string_view last_name(std::string_view pattern);

// "a number", "one of \"lumped\", \"consistent\"": what a value of this form is.
std::string kind_text(const Form& form);

// A document with one entry in every list: what the defaults are read from.
Document blank_document();

}  // namespace app
