#include "app/picture/labels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "render/view.h"

namespace app {
namespace {

// What the camera sees of points: right and up on the screen, of perspective as shares of the distance, and how far
// ahead they are.
class Sight {
 public:
  explicit Sight(const render::Camera& camera) : eye_(render::to_vector(camera.eye)), flat_(camera.orthographic) {
    ahead_ = (render::to_vector(camera.target) - eye_).normalized();
    const Eigen::Vector3f up = render::to_vector(camera.up);
    up_ = (up - up.dot(ahead_) * ahead_).normalized();
    right_ = ahead_.cross(up_);
  }

  const Eigen::Vector3f& up() const { return up_; }
  Eigen::Vector3f operator()(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f p = point - eye_;
    const float depth = ahead_.dot(p);
    const float scale = flat_ ? 1 : 1 / std::max(depth, 1e-6F);
    return {right_.dot(p) * scale, up_.dot(p) * scale, depth};
  }

 private:
  Eigen::Vector3f eye_, ahead_, up_, right_;
  bool flat_;
};

// A body on the screen.
struct Seen {
  Eigen::AlignedBox2f box;
  float depth = 0;
  Eigen::Vector3f top, bottom;  // the places for its name
};

Seen seen(const render::Surface& surface, const Sight& sight) {
  const Eigen::Map<const Eigen::Matrix3Xf> points(surface.positions.data(), 3,
                                                  static_cast<Eigen::Index>(surface.positions.size() / 3));
  Seen it;
  for (const auto& point : points.colwise()) it.box.extend(Eigen::Vector2f(sight(point).head<2>()));
  const Eigen::Vector3f middle = points.rowwise().mean();
  const Eigen::RowVectorXf heights = sight.up().transpose() * points;
  it.depth = sight(middle).z();
  it.top = middle + (heights.maxCoeff() - sight.up().dot(middle)) * sight.up();
  it.bottom = middle + (heights.minCoeff() - sight.up().dot(middle)) * sight.up();
  return it;
}

}  // namespace

void add_labels(std::size_t count, render::Frame& frame) {
  const Sight sight(frame.camera);
  std::vector<Seen> all;
  for (const render::Surface& surface : frame.surfaces)
    if (!surface.positions.empty()) all.push_back(seen(surface, sight));
  for (std::size_t i = 0, k = 0; i < std::min(count, frame.surfaces.size()); ++i) {
    if (frame.surfaces[i].positions.empty()) continue;
    const Seen& own = all[k++];
    const auto hidden = [&](const Eigen::Vector3f& place) {
      const Eigen::Vector2f at = sight(place).head<2>();
      return std::any_of(all.begin(), all.end(), [&](const Seen& other) {
        const bool nearer = frame.camera.orthographic || other.depth < own.depth;
        return &other != &own && nearer && other.box.contains(at);
      });
    };
    const bool below = hidden(own.top) && !hidden(own.bottom);
    const Eigen::Vector3f& at = below ? own.bottom : own.top;
    frame.labels.push_back({{at.x(), at.y(), at.z()}, frame.surfaces[i].name, below});
  }
}

}  // namespace app
