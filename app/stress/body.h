// The bodies that `ritz stress` puts to the test when no scene is named: one row each in a table.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/mesh/mesh.h"

namespace app {

// Which part of the matrix a body takes.
enum class Part {
  reference,  // all extremes, in three materials and schemes; other materials and schemes in part
  element,    // a body of another kind of element: starts and meshes
  shape,      // a membrane or an unstructured mesh: all extremes, in one material and scheme
  beam,       // bending, in one material and scheme
  own,        // the body of a scene: all extremes
};

struct TestBody {
  std::string_view name;
  std::string_view element;
  Part part;
  double thickness;  // m, of what is flat
  sim::Mesh (*make)(const TestBody&);
  std::string_view file = {};  // in the folder of meshes that come with the program
};

std::span<const TestBody> test_bodies();

}  // namespace app
