// A compile-time list of types, and how to go through it.
#pragma once

#include <cassert>
#include <type_traits>

namespace sim {

template <class... T>
struct TypeList {};

// Calls f(std::type_identity<T>{}) for every T of the list, in its order.
template <class... T, class F>
constexpr void for_each_type(TypeList<T...>, F&& f) {
  (f(std::type_identity<T>{}), ...);
}

// Returns f(std::type_identity<T>{}) for the first T for which matches(std::type_identity<T>{}) is true; one must be.
// f returns the same type for every T.
template <class Head, class... Tail, class Match, class F>
constexpr decltype(auto) visit_type(TypeList<Head, Tail...>, const Match& matches, F&& f) {
  if constexpr (sizeof...(Tail) > 0) {
    if (!matches(std::type_identity<Head>{})) return visit_type(TypeList<Tail...>{}, matches, f);
  }
  assert(matches(std::type_identity<Head>{}));
  return f(std::type_identity<Head>{});
}

}  // namespace sim
