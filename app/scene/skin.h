// The surface that is drawn instead of a body's own: its vertices ride on the tets.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/mesh/locate.h"
#include "sim/mesh/mesh.h"

namespace app {

struct Skin {
  Eigen::Matrix3Xi triangles;              // counter-clockwise seen from outside
  std::vector<sim::MaterialPoint> points;  // a vertex each; weights of the corners of an element
};

// A surface of triangles in space on a body of tets. Throws InputError (key "mesh.skin") where it is none, or farther
// from the body than it is large.
Skin make_skin(const sim::Mesh& surface, const sim::Mesh& body);

}  // namespace app
