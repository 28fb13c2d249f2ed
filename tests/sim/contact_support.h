// Scenes of bodies that touch: for the tests of contact.
#pragma once

#include <string>

#include "sim/mesh/transform.h"
#include "tests/sim/crossings.h"
#include "tests/sim/scenes.h"

namespace sim::test {

// A box of cells^3 cells with its low corner at `low`.
inline Body box_body(const std::string& name, const Vec3& size, int cells, const Vec3& low, double young = 1e5,
                     ElementKind kind = ElementKind::tet4) {
  Body body;
  body.name = name;
  body.mesh = generate_box({size[0], size[1], size[2]}, {cells, cells, cells}, {1, 1, 1}, kind);
  translate(body.mesh, low);
  body.materials = {MaterialSpec{"stable-neo-hookean", young, 0.4, 1000, ""}};
  return body;
}

// An eighth of a ball around the origin, 0 <= x, y and z <= 0, of hexahedra: the half of a cube, each point drawn in so
// that its largest coordinate becomes its distance. Cells are finest at the pole, z = -radius.
inline Mesh quarter_of_half_sphere(double radius, int cells, double grading) {
  Mesh mesh = generate_box({1, 1, 1}, {cells, cells, cells}, {grading, grading, grading}, ElementKind::hex8);
  for (Eigen::Index i = 0; i < mesh.X.cols(); ++i) {
    const Vec3 cube(mesh.X(0, i), mesh.X(1, i), mesh.X(2, i) - 1);
    if (const double length = cube.norm(); length > 0)
      mesh.X.col(i) = radius * cube.lpNorm<Eigen::Infinity>() / length * cube;
    else
      mesh.X.col(i).setZero();
  }
  return mesh;
}

// The surface of a mesh as an obstacle, that moves by `translate_by` in the first second.
inline Obstacle surface_obstacle(const Mesh& mesh, const Vec3& translate_by = {0, 0, 0}) {
  Obstacle obstacle;
  const int D = mesh.dimension();
  obstacle.shape = RigidSurface{mesh.X, D == 2 ? boundary_facets(mesh) : surface_facets(mesh)};
  if (!translate_by.isZero()) {
    obstacle.motion = {Keyframe{}, Keyframe{}};
    obstacle.motion[1].t = 1;
    obstacle.motion[1].translate = translate_by;
  }
  return obstacle;
}

// A box from `low`.
inline Mesh box_mesh(const Vec3& size, const Vec3& low, int cells = 1) {
  Mesh mesh = generate_box({size[0], size[1], size[2]}, {cells, cells, cells}, {1, 1, 1}, ElementKind::tet4);
  translate(mesh, low);
  return mesh;
}

// Two boxes of 1 m, one falls from `height` above the other, which is held at its foot.
inline Scene two_boxes(int cells, double height, ElementKind kind = ElementKind::tet4) {
  Scene scene;
  scene.bodies = {box_body("low", {1, 1, 1}, cells, {0, 0, 0}, 1e5, kind),
                  box_body("top", {1, 1, 1}, cells, {0.13, 1 + height, 0.07}, 1e5, kind)};
  scene.bodies[0].pins = {Pin{Box{{-1, -1e-6, -1}, {2, 1e-6, 2}}, "xyz", {}, {}}};
  scene.contacts = {Contact{}};
  return scene;
}

}  // namespace sim::test
