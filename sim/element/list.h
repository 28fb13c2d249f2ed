// Every element: a new one is its own file, a value of ElementKind and a line here.
#pragma once

#include <type_traits>

#include "sim/element/hex8.h"
#include "sim/element/quad4.h"
#include "sim/element/tet10.h"
#include "sim/element/tet4.h"
#include "sim/element/tri3.h"
#include "sim/element/tri6.h"
#include "sim/math/type_list.h"

namespace sim {

using Elements = TypeList<Tri3, Tri6, Quad4, Tet4, Tet10, Hex8>;

// Returns f(std::type_identity<Element>{}) for the element of this kind.
template <class F>
constexpr decltype(auto) visit_element(ElementKind kind, F&& f) {
  return visit_type(
      Elements{}, [kind]<class E>(std::type_identity<E>) { return E::kind == kind; }, f);
}

}  // namespace sim
