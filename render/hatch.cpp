#include "render/hatch.h"

#include <algorithm>
#include <cmath>

namespace render {

void draw_hatched_planes(const Page& page, const Frame& frame, const View& view) {
  if (!view.orthographic) return;
  constexpr float edge_on = 1e-3F;
  const Eigen::Vector2f middle(page.width / 2, page.height / 2);
  const float reach = middle.norm();
  const float spacing = 0.9F * page.size, length = 0.6F * page.size;
  const float thick = std::max(1.0F, 0.08F * page.size);
  const auto line = [&](const Eigen::Vector2f& a, const Eigen::Vector2f& b, float width) {
    page.list->AddLine({a.x(), a.y()}, {b.x(), b.y()}, Page::soft_ink, width);
  };
  for (const PlaneObstacle& plane : frame.planes) {
    const Eigen::Vector3f normal = to_vector(plane.normal).normalized();
    if (std::abs(normal.dot(view.forward)) > edge_on) continue;
    const Eigen::Vector2f out = Eigen::Vector2f(normal.dot(view.right), -normal.dot(view.up)).normalized();
    const Eigen::Vector2f along(-out.y(), out.x());
    const Eigen::Vector2f at =
        view.to_window(to_vector(plane.point), static_cast<int>(page.width), static_cast<int>(page.height)).head<2>();
    const float away = (middle - at).dot(out);
    if (std::abs(away) > reach + length) continue;
    const Eigen::Vector2f foot = middle - away * out;
    line(foot - reach * along, foot + reach * along, 1.5F * thick);
    for (float s = -reach; s < reach; s += spacing) {
      const Eigen::Vector2f top = foot + s * along;
      line(top, top - length * (out + along), thick);
    }
  }
}

}  // namespace render
