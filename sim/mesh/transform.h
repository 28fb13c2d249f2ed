// Places a mesh.
#pragma once

#include "sim/math/vec3.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/mesh.h"

namespace sim {

// In a plane mesh the third number of a vector is ignored.

// X + offset [m]
void translate(Mesh& mesh, const Vec3& offset);
// Rotation about an axis through the origin (right-hand rule). A plane mesh turns about z only.
// Throws InputError (mesh.rotate) when the axis is zero or not finite, or not z in the plane.
void rotate(Mesh& mesh, const Vec3& axis, double degrees);
// X times a factor per axis. Throws InputError (mesh.scale) when one is zero or not finite. An odd number of negative
// factors mirrors the mesh: check_and_orient puts its elements right.
void scale(Mesh& mesh, const Vec3& factors);

}  // namespace sim
