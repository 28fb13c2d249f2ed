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
inline Value to_value(bool x) {
  return x;
}
inline Value to_value(int x) {
  return std::int64_t{x};
}
inline Value to_value(std::uint64_t x) {
  return static_cast<std::int64_t>(x);
}
inline Value to_value(double x) {
  return x;
}
inline Value to_value(const std::string& x) {
  return x;
}
inline Value to_value(const std::filesystem::path& x) {
  return x.string();
}
inline Value to_value(const Vec3& x) {
  return std::vector<double>{x.begin(), x.end()};
}
inline Value to_value(const std::array<double, 2>& x) {
  return std::vector<double>{x.begin(), x.end()};
}
inline Value to_value(const std::vector<double>& x) {
  return x;
}
inline Value to_value(const std::vector<int>& x) {
  return std::vector<double>{x.begin(), x.end()};
}
inline Value to_value(const sim::InGroup& x) {
  return x.name;
}
inline Value to_value(const sim::Sphere& x) {
  return std::vector<double>{x.centre[0], x.centre[1], x.centre[2], x.radius};
}
inline Value to_value(const sim::Box& x) {
  return std::vector<double>{x.low[0], x.low[1], x.low[2], x.high[0], x.high[1], x.high[2]};
}
// An enum of sim/choices.h.
template <class E>
requires std::is_enum_v<E> Value to_value(E x) {
  return std::string(sim::name_of(x));
}

// Value -> field; the value has been checked against its key.
inline void from_value(const Value& value, bool& x) {
  x = std::get<bool>(value);
}
inline void from_value(const Value& value, int& x) {
  x = static_cast<int>(std::get<std::int64_t>(value));
}
inline void from_value(const Value& value, std::uint64_t& x) {
  x = static_cast<std::uint64_t>(std::get<std::int64_t>(value));
}
inline void from_value(const Value& value, double& x) {
  x = std::get<double>(value);
}
inline void from_value(const Value& value, std::string& x) {
  x = std::get<std::string>(value);
}
inline void from_value(const Value& value, std::filesystem::path& x) {
  x = std::get<std::string>(value);
}
inline void from_value(const Value& value, std::vector<double>& x) {
  x = std::get<std::vector<double>>(value);
}
inline void from_value(const Value& value, sim::InGroup& x) {
  x.name = std::get<std::string>(value);
}
inline void from_value(const Value& value, Vec3& x) {
  std::ranges::copy(std::get<std::vector<double>>(value), x.begin());
}
inline void from_value(const Value& value, std::array<double, 2>& x) {
  std::ranges::copy(std::get<std::vector<double>>(value), x.begin());
}
inline void from_value(const Value& value, std::vector<int>& x) {
  const auto& numbers = std::get<std::vector<double>>(value);
  x.assign(numbers.begin(), numbers.end());
}
inline void from_value(const Value& value, sim::Sphere& x) {
  const auto& n = std::get<std::vector<double>>(value);
  x = {{n[0], n[1], n[2]}, n[3]};
}
inline void from_value(const Value& value, sim::Box& x) {
  const auto& n = std::get<std::vector<double>>(value);
  x = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}
template <class E>
requires std::is_enum_v<E>
void from_value(const Value& value, E& x) {
  x = std::ranges::find(sim::choices<E>, std::get<std::string>(value), &sim::Choice<E>::name)->value;
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

// The length of the vector owner(document, indices).*member.
template <auto owner, auto member>
constexpr Binding length = {
    [](const Document& d, const Indices& i) { return std::optional<Value>(std::ssize(owner(d, i).*member)); },
    [](Document& d, const Indices& i, const Value& n) { (owner(d, i).*member).resize(std::get<std::int64_t>(n)); }};

// One alternative T of the variant owner(document, indices).*member.
template <auto owner, auto member, class T>
constexpr Binding alternative = {[](const Document& d, const Indices& i) -> std::optional<Value> {
                                   const T* held = std::get_if<T>(&(owner(d, i).*member));
                                   return held ? std::optional<Value>(to_value(*held)) : std::nullopt;
                                 },
                                 [](Document& d, const Indices& i, const Value& value) {
                                   from_value(value, (owner(d, i).*member).template emplace<T>());
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
inline constexpr auto traction_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).tractions[i[1]];
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

// The parts of the table.
std::vector<Key> time_keys();
std::vector<Key> solver_keys();
std::vector<Key> world_keys();
std::vector<Key> body_keys();
std::vector<Key> start_keys();
std::vector<Key> mesh_keys();
std::vector<Key> material_keys();
std::vector<Key> pin_keys();
std::vector<Key> load_keys();
std::vector<Key> obstacle_keys();
std::vector<Key> spring_keys();
std::vector<Key> probe_keys();
std::vector<Key> camera_keys();
std::vector<Key> look_keys();

}  // namespace app
