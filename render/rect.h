// Which part of a picture things cover.
#pragma once

#include <Eigen/Core>

#include "render/frame.h"
#include "render/view.h"

namespace render {

// Pixels low x, low y, width, height; origin at the lower left.
struct Rect {
  int x = 0, y = 0, width = 0, height = 0;
  bool empty() const { return width <= 0 || height <= 0; }
};

// The smallest rectangle that holds both; empty ones do not count.
Rect united(const Rect& a, const Rect& b);

// The part of a picture of width x height pixels that the points cover, with a margin in pixels; all of it when one of
// them lies too near to the eye to be projected.
Rect rect_of(const Eigen::Ref<const Eigen::Matrix3Xf>& points, const View& view, int width, int height, float margin);

// Where a plane can be darkened by a solid with these vertices: below them, and where their shadow falls when the light
// comes from `key` (unit, towards the light). The margin in pixels is the width of the darkening around contacts.
Rect shade_rect(const Point& point, const Point& normal, const Eigen::Ref<const Eigen::Matrix3Xf>& vertices,
                const Eigen::Vector3f& key, const View& view, int width, int height, float margin);

}  // namespace render
