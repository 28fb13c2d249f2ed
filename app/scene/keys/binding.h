// Bindings of keys to fields, made from an owner (which struct of the document) and a pointer to its member.
#pragma once

#include <algorithm>
#include <concepts>
#include <span>
#include <type_traits>
#include <utility>

#include "app/scene/keys.h"

namespace app {

// Field -> value.
template <class T>
Value to_value(const T& x) {
  if constexpr (std::is_enum_v<T>)
    return std::string(sim::name_of(x));  // of sim/choices.h
  else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    return static_cast<std::int64_t>(x);
  else if constexpr (std::is_same_v<T, std::filesystem::path>)
    return x.string();
  else if constexpr (std::is_same_v<T, sim::InGroup>)
    return x.name;
  else if constexpr (std::is_same_v<T, sim::Sphere>)
    return std::vector<double>{x.centre[0], x.centre[1], x.centre[2], x.radius};
  else if constexpr (std::is_same_v<T, sim::Box>)
    return std::vector<double>{x.low[0], x.low[1], x.low[2], x.high[0], x.high[1], x.high[2]};
  else if constexpr (std::is_constructible_v<Value, const T&>)
    return x;
  else
    return std::vector<double>(x.begin(), x.end());
}

inline Value to_value(const std::vector<Vec3>& points) {
  std::vector<double> all;
  for (const Vec3& x : points) all.insert(all.end(), x.begin(), x.end());
  return all;
}

// Value -> field; the value has been checked against its key.
template <class T>
void from_value(const Value& value, T& x) {
  [[maybe_unused]] const auto* const n = std::get_if<std::vector<double>>(&value);
  if constexpr (std::is_enum_v<T>)
    x = std::ranges::find(sim::choices<T>, std::get<std::string>(value), &sim::Choice<T>::name)->value;
  else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    x = static_cast<T>(std::get<std::int64_t>(value));
  else if constexpr (std::is_same_v<T, std::filesystem::path>)
    x = std::get<std::string>(value);
  else if constexpr (std::is_same_v<T, sim::InGroup>)
    x.name = std::get<std::string>(value);
  else if constexpr (std::is_same_v<T, sim::Sphere>)
    x = {{(*n)[0], (*n)[1], (*n)[2]}, (*n)[3]};
  else if constexpr (std::is_same_v<T, sim::Box>)
    x = {{(*n)[0], (*n)[1], (*n)[2]}, {(*n)[3], (*n)[4], (*n)[5]}};
  else if constexpr (std::is_constructible_v<Value, const T&>)
    x = std::get<T>(value);
  else if constexpr (std::is_same_v<T, std::vector<int>>)
    x.assign(n->begin(), n->end());
  else
    std::ranges::copy(*n, x.begin());
}

inline void from_value(const Value& value, std::vector<Vec3>& points) {
  const auto& n = std::get<std::vector<double>>(value);
  points.clear();
  for (std::size_t i = 0; i + 2 < n.size(); i += 3) points.push_back({n[i], n[i + 1], n[i + 2]});
}

template <class T>
std::optional<Value> to_optional(const T& x) {
  return to_value(x);
}
template <class T>
std::optional<Value> to_optional(const std::optional<T>& x) {
  if (!x) return std::nullopt;
  return to_value(*x);
}
template <class T>
void from_value(const Value& value, std::optional<T>& x) {
  from_value(value, x.emplace());
}

// owner(document, indices).*member.
template <auto owner, auto member>
constexpr Binding field = {
    [](const Document& d, const Indices& i) { return to_optional(owner(d, i).*member); },
    [](Document& d, const Indices& i, const Value& value) { from_value(value, owner(d, i).*member); }};

// A list or text that is absent while it is empty.
template <auto owner, auto member>
constexpr Binding unless_empty = {[](const Document& d, const Indices& i) {
                                    const auto& held = owner(d, i).*member;
                                    return held.empty() ? std::nullopt : std::optional<Value>(to_value(held));
                                  },
                                  field<owner, member>.set};

// The length of the vector owner(document, indices).*member.
template <auto owner, auto member>
constexpr Binding length = {
    [](const Document& d, const Indices& i) { return std::optional<Value>(std::ssize(owner(d, i).*member)); },
    [](Document& d, const Indices& i, const Value& n) { (owner(d, i).*member).resize(std::get<std::int64_t>(n)); }};

// A variant that may be left out, or one that may not.
template <class V>
const V* held_in(const V& variant) {
  return &variant;
}
template <class V>
const V* held_in(const std::optional<V>& variant) {
  return variant ? &*variant : nullptr;
}
template <class V>
V& made_in(V& variant) {
  return variant;
}
template <class V>
V& made_in(std::optional<V>& variant) {
  return variant ? *variant : variant.emplace();
}

// One alternative T of the variant owner(document, indices).*member.
template <auto owner, auto member, class T>
constexpr Binding alternative = {[](const Document& d, const Indices& i) -> std::optional<Value> {
                                   const auto* variant = held_in(owner(d, i).*member);
                                   const T* held = variant ? std::get_if<T>(variant) : nullptr;
                                   return held ? std::optional<Value>(to_value(*held)) : std::nullopt;
                                 },
                                 [](Document& d, const Indices& i, const Value& value) {
                                   from_value(value, made_in(owner(d, i).*member).template emplace<T>());
                                 }};

// Owners.
inline constexpr auto whole_document = [](auto& d, const Indices&) -> auto& {
  return d;
};
inline constexpr auto scene_of = [](auto& d, const Indices&) -> auto& {
  return d.scene;
};
inline constexpr auto body_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.bodies[i[0]];
};
inline constexpr auto pin_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).pins[i[1]];
};
inline constexpr auto loads_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).loads;
};
inline constexpr auto pressure_of = [](auto& d, const Indices& i) -> auto& {
  return loads_of(d, i).pressures[i[1]];
};
inline constexpr auto force_of = [](auto& d, const Indices& i) -> auto& {
  return loads_of(d, i).forces[i[1]];
};
inline constexpr auto traction_of = [](auto& d, const Indices& i) -> auto& {
  return loads_of(d, i).tractions[i[1]];
};

// Ranges.
inline Range above(double low) {
  return {.low = low, .low_open = true};
}
inline Range at_least(double low) {
  return {.low = low};
}
inline Range between(double low, double high) {
  return {.low = low, .high = high};
}
inline Range inside(double low, double high) {
  return {.low = low, .high = high, .low_open = true, .high_open = true};
}

inline void append(std::vector<Key>& table, const std::vector<Key>& more) {
  table.insert(table.end(), more.begin(), more.end());
}

// The same keys in the table at this path: "young" -> "body[].material.young".
inline std::vector<Key> below(std::string_view path, std::vector<Key> table) {
  for (Key& key : table) key.path = std::string(path) + "." + key.path;
  return table;
}

// The parts of the table.
std::vector<Key> time_keys();
std::vector<Key> solver_keys();
std::vector<Key> world_keys();
std::vector<Key> body_keys();
std::vector<Key> start_keys();
std::vector<Key> basis_keys();
std::vector<Key> mesh_keys();
std::vector<Key> obstacle_mesh_keys();
std::vector<Key> material_keys();
std::vector<Key> pin_keys();
std::vector<Key> load_keys();
std::vector<Key> obstacle_keys();
std::vector<Key> contact_keys();
std::vector<Key> spring_keys();
std::vector<Key> probe_keys();
std::vector<Key> camera_keys();
std::vector<Key> look_keys();
std::vector<Key> exhibit_keys();

}  // namespace app
