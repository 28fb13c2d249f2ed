#include "app/view/mouse.h"

#include "app/view/camera_moves.h"

namespace app {
namespace {

using render::Button;
using render::WindowEvent;

Ray ray_of(const WindowEvent& event, const Scenery& now) {
  const double width = now.width, height = now.height;
  return ray_through(now.frame.camera, width / height, event.x / width, event.y / height);
}

}  // namespace

std::optional<Input> Mouse::handle(const WindowEvent& event, const Scenery& now) {
  switch (event.kind) {
    case WindowEvent::Kind::press:
      return press(event, now);
    case WindowEvent::Kind::move:
      return move(event, now);
    case WindowEvent::Kind::release:
      return release(event);
    case WindowEvent::Kind::scroll:
      return zoom(now.frame.camera, event.scroll);
    default:
      return std::nullopt;
  }
}

std::optional<Input> Mouse::press(const WindowEvent& event, const Scenery& now) {
  if (held_) return std::nullopt;
  x_ = event.x;
  y_ = event.y;
  held_ = event.button;
  if (event.button != Button::left || !event.control) return std::nullopt;
  const Ray ray = ray_of(event, now);
  const std::optional<Picked> picked = pick(ray, now.frame, now.system, now.state);
  if (!picked) return std::nullopt;
  grip_ = {*picked, on_plane(ray, now.frame.camera, picked->now - origin_of(now.frame))};
  return Pull{now.system.bodies()[static_cast<std::size_t>(picked->body)].name, picked->rest, picked->now};
}

std::optional<Input> Mouse::move(const WindowEvent& event, const Scenery& now) {
  if (!held_) return std::nullopt;
  const double right = (event.x - x_) / now.height, down = (event.y - y_) / now.height;
  x_ = event.x;
  y_ = event.y;
  if (grip_) {
    const sim::Vec3 &begin = grip_->picked.now, origin = origin_of(now.frame);
    return PullTo{begin + on_plane(ray_of(event, now), now.frame.camera, begin - origin) - grip_->from};
  }
  if (right == 0 && down == 0) return std::nullopt;
  return *held_ == Button::left ? orbit(now.frame.camera, right, down) : pan(now.frame.camera, right, down);
}

std::optional<Input> Mouse::release(const WindowEvent& event) {
  if (!held_ || *held_ != event.button) return std::nullopt;
  held_.reset();
  if (!grip_) return std::nullopt;
  grip_.reset();
  return Release{};
}

}  // namespace app
