#include "render/rect.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace render {

Rect united(const Rect& a, const Rect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

Rect rect_of(const Eigen::Ref<const Eigen::Matrix3Xf>& points, const View& view, int width, int height, float margin) {
  Eigen::Vector2f low(1e9F, 1e9F), high(-1e9F, -1e9F);
  const Eigen::Vector2f most(static_cast<float>(width), static_cast<float>(height));
  for (const auto& point : points.colwise()) {
    const Eigen::Vector4f clip = view.world_to_clip * point.homogeneous();
    // For a perspective camera w is the depth.
    if (!view.orthographic && clip.w() < view.near_distance) return {0, 0, width, height};
    const Eigen::Vector2f pixel = (clip.head<2>() / clip.w()).array() * 0.5F + 0.5F;
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  if (low.x() > high.x()) return {};
  low = (low.cwiseProduct(most).array() - margin).max(0).min(most.array());
  high = (high.cwiseProduct(most).array() + margin).max(0).min(most.array());
  const int x = static_cast<int>(std::floor(low.x())), y = static_cast<int>(std::floor(low.y()));
  return {x, y, static_cast<int>(std::ceil(high.x())) - x, static_cast<int>(std::ceil(high.y())) - y};
}

Rect shade_rect(const Point& point, const Point& normal, const Eigen::Ref<const Eigen::Matrix3Xf>& vertices,
                const Eigen::Vector3f& key, const View& view, int width, int height, float margin) {
  const Eigen::Vector3f up = to_vector(normal).normalized();
  const float slant = up.dot(key);
  const Eigen::RowVectorXf above = up.transpose() * (vertices.colwise() - to_vector(point));
  Eigen::Matrix3Xf points(3, 2 * vertices.cols());
  points.leftCols(vertices.cols()) = vertices - up * above;
  // Along a plane that the light grazes the shadow has no end: it is left out.
  const float reach = slant > 0.05F ? 1 / slant : 0;
  points.rightCols(vertices.cols()) = vertices - (reach > 0 ? key : up) * (above * (reach > 0 ? reach : 1));
  return rect_of(points, view, width, height, margin);
}

}  // namespace render
