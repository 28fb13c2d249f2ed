#include "app/view/ring_drag.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace app {
namespace {

constexpr double ring_reach = 0.035;  // of the picture's height: as far from its middle a ring is taken

std::optional<std::size_t> ring_under(const render::WindowEvent& mouse, const std::vector<Ring>& rings, int width,
                                      int height) {
  std::optional<std::size_t> under;
  double nearest = ring_reach * height;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const render::Spot at = render::to_page(rings[k].diagram, rings[k].grip.at, width, height);
    const double distance = std::hypot(at[0] - mouse.x, at[1] - mouse.y);
    if (distance >= nearest) continue;
    nearest = distance;
    under = k;
  }
  return under;
}

}  // namespace

RingDrag::Answer RingDrag::handle(const render::WindowEvent& event, const FrameHistory& frames, const sim::State& state,
                                  int width, int height) {
  using Kind = render::WindowEvent::Kind;
  if (event.kind == Kind::release) return {std::exchange(ring_, std::nullopt).has_value(), {}};
  if (event.kind == Kind::press && event.button == render::Button::left && !event.control) {
    ring_ = ring_under(event, frames.rings(state), width, height);
    return {ring_.has_value(), {}};
  }
  if (!ring_ || event.kind != Kind::move) return {};
  const std::vector<Ring> rings = frames.rings(state);
  if (*ring_ >= rings.size()) return {true, {}};
  const Ring& ring = rings[*ring_];
  // It stays where it is seen, and can be taken again.
  const render::Box area = render::area_of(ring.diagram, width, height);
  const render::Spot to = {std::clamp<double>(event.x, area.left, area.right),
                           std::clamp<double>(event.y, area.top, area.bottom)};
  return {true, SetKey{ring.key, ring.grip.value(render::from_page(ring.diagram, to, width, height))}};
}

}  // namespace app
