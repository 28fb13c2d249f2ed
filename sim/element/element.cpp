#include "sim/element/element.h"

#include "sim/element/list.h"

namespace sim {
namespace {

template <class E>
constexpr ElementInfo element_info = {E::kind,  E::name,         E::dimension, E::nodes, E::corners,
                                      E::order, E::Facet::nodes, E::facets,    E::edges};

}  // namespace

const ElementInfo& info(ElementKind kind) {
  return visit_element(kind, []<class E>(std::type_identity<E>) -> const ElementInfo& { return element_info<E>; });
}

const ElementInfo* find_element(std::string_view name) {
  const ElementInfo* found = nullptr;
  for_each_type(Elements{}, [&]<class E>(std::type_identity<E>) {
    if (E::name == name) found = &element_info<E>;
  });
  return found;
}

}  // namespace sim
