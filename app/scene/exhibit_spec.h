// `[[exhibit]]` of a scene: what a page of a lecture shows, as plain data. What a value means depends on the kind;
// which kind has which is told by the table in exhibits.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/math/vec3.h"

namespace app {

struct ExhibitSpec {
  std::string kind;
  std::string body;              // name; empty: the first body
  int element = 0;               // number in the body's mesh, from 0
  int node = -1;                 // of the element or the mesh, from 0; -1: one after the other
  int count = 4;                 // how many of what the kind counts
  double pace = 1;               // s from one thing shown to the next
  std::vector<sim::Vec3> nodes;  // m: where the nodes of the element are held; empty: where the body has them
  std::vector<double> values;    // numbers that can be dragged
  std::string basis;             // functions or elements
  std::string method;            // by which coefficients are chosen; empty: one after the other
  std::string rows;              // of a large system: which of them are kept
  std::string problem;           // file of a differential equation, beside the scene file
  double wind = 0;               // what makes the large system unsymmetric
  std::optional<double> eps;     // diffusion beside an advection of 1
  bool anyway = false;           // Ritz's method where it does not apply

  bool operator==(const ExhibitSpec&) const = default;
};

}  // namespace app
