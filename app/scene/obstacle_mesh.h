// The surface of an obstacle: how a scene describes it, and the sim::RigidSurface that comes of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene/body_mesh.h"
#include "sim/scene.h"

namespace app {

// `box = [...]` or `mesh = {...}` of an obstacle; neither where it is a plane or a sphere.
struct ObstacleMesh {
  std::optional<sim::Box> box;
  MeshSpec spec;
  Eigen::Matrix3Xi triangles;  // nodes of the surface: what the picture shows; none of lines

  bool is_given() const { return box || spec.source != MeshSource::none; }
};

// Makes the surface, placed in a scene of this dimension. Throws sim::InputError with a key below the obstacle's, and
// FileError. Remarks are added for what was mended.
sim::RigidSurface make_surface(ObstacleMesh& mesh, int dimension, std::vector<std::string>& remarks);

}  // namespace app
