#include "app/picture/labels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "render/view.h"

namespace app {
namespace {

// A body on the screen.
struct Seen {
  Eigen::AlignedBox2f box;
  float depth = 0;
  Eigen::Vector3f top, middle, bottom;  // the places for its name
};

// On a screen one pixel wide and high; third: how far ahead.
Eigen::Vector3f on_screen(const render::View& view, const Eigen::Vector3f& point) {
  return view.to_window(point, 1, 1);
}

Seen seen(const render::Surface& surface, const render::View& view) {
  const Eigen::Map<const Eigen::Matrix3Xf> points(surface.positions.data(), 3,
                                                  static_cast<Eigen::Index>(surface.positions.size() / 3));
  Seen it;
  for (const auto& point : points.colwise()) {
    const Eigen::Vector3f at = on_screen(view, point);
    if (view.orthographic || at.z() > 0) it.box.extend(Eigen::Vector2f(at.head<2>()));
  }
  const Eigen::Vector3f middle = it.middle = points.rowwise().mean();
  const Eigen::RowVectorXf heights = view.up.transpose() * points;
  it.depth = on_screen(view, middle).z();
  it.top = middle + (heights.maxCoeff() - view.up.dot(middle)) * view.up;
  it.bottom = middle + (heights.minCoeff() - view.up.dot(middle)) * view.up;
  return it;
}

}  // namespace

void add_labels(std::size_t count, render::Frame& frame) {
  const render::View view = render::make_view(frame.camera, 1, {});
  std::vector<Seen> all;
  for (const render::Surface& surface : frame.surfaces)
    if (!surface.positions.empty()) all.push_back(seen(surface, view));
  for (std::size_t i = 0, k = 0; i < std::min(count, frame.surfaces.size()); ++i) {
    if (frame.surfaces[i].positions.empty()) continue;
    const Seen& own = all[k++];
    const auto hidden = [&](const Eigen::Vector3f& place) {
      const Eigen::Vector2f at = on_screen(view, place).head<2>();
      return std::any_of(all.begin(), all.end(), [&](const Seen& other) {
        const bool nearer = frame.camera.orthographic || other.depth < own.depth;
        return &other != &own && nearer && other.box.contains(at);
      });
    };
    // Between others, as in a stack, a name stands on its own body rather than on one of them.
    const bool between = hidden(own.top) && hidden(own.bottom), below = !between && hidden(own.top);
    const Eigen::Vector3f& at = between ? own.middle : below ? own.bottom : own.top;
    frame.labels.push_back({{at.x(), at.y(), at.z()}, frame.surfaces[i].name, below});
  }
}

}  // namespace app
