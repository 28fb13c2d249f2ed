#include "sim/mesh/transform.h"

#include <Eigen/Geometry>
#include <numbers>
#include <sstream>

#include "sim/mesh/input_error.h"

namespace sim {
namespace {

std::string text(const Vec3& v) {
  std::ostringstream out;
  out << "[" << v[0] << ", " << v[1] << ", " << v[2] << "]";
  return out.str();
}

}  // namespace

void translate(Mesh& mesh, const Vec3& offset) {
  mesh.X.colwise() += offset.head(mesh.dimension());
}

void rotate(Mesh& mesh, const Vec3& axis, double degrees) {
  if (!axis.allFinite() || axis.norm() == 0 || !std::isfinite(degrees)) {
    std::ostringstream message;
    message << "a rotation needs an axis that is not zero and a finite angle; axis = " << text(axis) << ", " << degrees
            << " degrees";
    throw InputError("mesh.rotate", message.str());
  }
  if (mesh.dimension() == 2 && (axis[0] != 0 || axis[1] != 0)) {
    throw InputError("mesh.rotate", "a plane mesh turns about the axis [0, 0, 1] only, not " + text(axis));
  }
  const double angle = degrees * std::numbers::pi / 180;
  const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  const int d = mesh.dimension();
  mesh.X = (R.topLeftCorner(d, d) * mesh.X).eval();
}

void scale(Mesh& mesh, const Vec3& factors) {
  const auto used = factors.head(mesh.dimension());
  if (!used.allFinite() || (used.array() == 0).any()) {
    throw InputError("mesh.scale", "scale factors must be finite and not zero; they are " + text(factors));
  }
  mesh.X = (used.asDiagonal() * mesh.X).eval();
}

}  // namespace sim
