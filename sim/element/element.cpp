#include "sim/element/element.h"

#include <algorithm>

#include "sim/element/list.h"

namespace sim {
namespace {

template <class E>
constexpr ElementKind linear_of() {
  if constexpr (E::order == 2) return E::Linear::kind;
  return E::kind;
}

template <class E>
constexpr std::optional<ElementKind> quadratic_of() {
  std::optional<ElementKind> found;
  for_each_type(Elements{}, [&]<class Q>(std::type_identity<Q>) {
    if (Q::order == 2 && linear_of<Q>() == linear_of<E>()) found = Q::kind;
  });
  return found;
}

template <class E>
constexpr std::span<const int> gmsh_order_of() {
  if constexpr (requires { E::gmsh_order; }) return E::gmsh_order;
  return {};
}

template <class E>
constexpr ElementInfo row = {E::kind,
                             E::name,
                             E::dimension,
                             E::nodes,
                             E::corners,
                             E::order,
                             E::Facet::nodes,
                             E::facets,
                             E::edges,
                             linear_of<E>(),
                             quadratic_of<E>(),
                             E::membrane,
                             E::nodes_per_element,
                             E::vtk,
                             E::gmsh,
                             gmsh_order_of<E>()};

template <class... E>
constexpr auto table_of(TypeList<E...>) {
  return std::array{row<E>...};
}
constexpr auto table = table_of(Elements{});

}  // namespace

std::span<const ElementInfo> elements() {
  return table;
}

const ElementInfo& info(ElementKind kind) {
  return *std::ranges::find(table, kind, &ElementInfo::kind);
}

const ElementInfo* find_element(std::string_view name) {
  const auto found = std::ranges::find(table, name, &ElementInfo::name);
  return found == table.end() ? nullptr : &*found;
}

std::string element_list(bool (*right)(const ElementInfo&)) {
  std::string text;
  const auto count = std::ranges::count_if(table, right);
  std::ptrdiff_t number = 0;
  for (const ElementInfo& element : table)
    if (right(element)) {
      text += number == 0 ? "" : number + 1 == count ? " or " : ", ";
      text += element.name;
      ++number;
    }
  return text;
}

}  // namespace sim
