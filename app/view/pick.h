// What of a scene is under the mouse.
#pragma once

#include <optional>

#include "render/frame.h"
#include "sim/system.h"

namespace app {

struct Ray {
  sim::Vec3 origin, direction;  // direction: unit
};

// Through a place of the picture, in shares of its width and height from the upper left corner.
Ray ray_through(const render::Camera& camera, double aspect, double x, double y);

// What rays and cameras are relative to.
sim::Vec3 origin_of(const render::Frame& frame);

// Where the ray meets the plane through the point, parallel to the picture.
sim::Vec3 on_plane(const Ray& ray, const render::Camera& camera, const sim::Vec3& point);

struct Picked {
  int body = 0;
  int node = 0;    // of the body: the one nearest to where the ray meets its surface
  sim::Vec3 rest;  // m: where that node is at rest,
  sim::Vec3 now;   // and where it is
};

// The first body that the ray meets. The surfaces of the frame are the bodies of the system, in their order.
std::optional<Picked> pick(const Ray& ray, const render::Frame& frame, const sim::System& system,
                           const sim::State& state);

// Where a node of a body is.
sim::Vec3 place_of(const sim::System& system, const sim::State& state, int body, int node);

}  // namespace app
