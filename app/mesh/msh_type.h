// Gmsh's element types: what is known of each by its number.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/element/element.h"

namespace app {

struct MshType {
  int number;
  std::string_view name;
  int dimension;
  int nodes;
  const sim::ElementInfo* element;  // nullptr: a body cannot be made of it
};

// nullptr for a number that is not in the table (elements of order three and more, among others).
const MshType* find_msh_type(std::int64_t number);

}  // namespace app
