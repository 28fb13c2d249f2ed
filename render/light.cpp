#include "render/light.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace render {

Light light_of(const Frame& frame, const View& view) {
  Light light;
  light.up = (frame.ground ? to_vector(frame.ground->normal) : to_vector(frame.camera.up)).normalized();
  // Level directions of the viewer; from straight above, the screen's own.
  const Eigen::Vector3f across = view.forward.cross(light.up);
  const Eigen::Vector3f right = across.norm() > 1e-3F ? Eigen::Vector3f(across.normalized()) : view.right;
  const Eigen::Vector3f back = right.cross(light.up);
  light.key = (-0.60F * right + 1.00F * light.up + 0.50F * back).normalized();
  light.fill = (0.80F * right + 0.30F * light.up + 0.55F * back).normalized();
  return light;
}

Eigen::Matrix4f light_matrix(const Light& light, const Bounds& casters, int texels) {
  const Eigen::Vector3f side = light.key.unitOrthogonal();
  Eigen::Matrix3f axes;
  axes << side.transpose(), light.key.cross(side).transpose(), -light.key.transpose();
  Bounds box;
  for (int k = 0; k < 8; ++k) box.add(axes * casters.corner(k));
  // Square in x and y; its side grows in steps of a quarter octave, its middle moves by whole texels. The border of
  // an eighth leaves room for the width of the soft edge.
  const Eigen::Vector3f size = box.high - box.low;
  const float needed = std::max({size.x(), size.y(), 0.1F * size.z(), 1e-6F}) * 1.25F;
  const float width = std::exp2(std::ceil(std::log2(needed) * 4) / 4);
  const float texel = width / static_cast<float>(texels);
  Eigen::Vector3f low = (box.low + box.high) / 2 - Eigen::Vector3f::Constant(width / 2);
  low.x() = std::floor(low.x() / texel) * texel;
  low.y() = std::floor(low.y() / texel) * texel;
  // Receivers behind the casters lie beyond 1 and are compared all the same.
  const float depth = std::max(size.z(), 1e-6F) * 1.1F;
  low.z() = box.low.z() - 0.05F * depth;
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  const Eigen::Vector3f scale(1 / width, 1 / width, 1 / depth);
  matrix.block<3, 3>(0, 0) = scale.asDiagonal() * axes;
  matrix.block<3, 1>(0, 3) = -low.cwiseProduct(scale);
  return matrix;
}

}  // namespace render
