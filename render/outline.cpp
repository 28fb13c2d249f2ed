#include "render/outline.h"

#include <algorithm>

#include "render/diagram.h"

namespace render {
namespace {

void draw_outline(const Page& page, const Surface& surface, const View& view, ImU32 colour, float thickness) {
  const auto at = [&](std::uint32_t vertex) {
    const Eigen::Map<const Eigen::Vector3f> point(surface.positions.data() + 3 * static_cast<std::size_t>(vertex));
    const Eigen::Vector3f window = view.to_window(point, static_cast<int>(page.width), static_cast<int>(page.height));
    return ImVec2(window.x() - 0.5F, window.y() - 0.5F);  // a draw list counts from the middle of the first pixel
  };
  const auto seen = [&](ImVec2 p) {
    return p.x > -page.width && p.x < 2 * page.width && p.y > -page.height && p.y < 2 * page.height;
  };
  for (std::size_t k = 0; k + 1 < surface.outline.size(); k += 2) {
    const ImVec2 from = at(surface.outline[k]), to = at(surface.outline[k + 1]);
    if (seen(from) || seen(to)) page.list->AddLine(from, to, colour, thickness);
  }
}

}  // namespace

void draw_outlines(const Page& page, const Frame& frame, const View& view) {
  const float thickness = frame.look.lecture ? line_width(page) : std::max(1.0F, page.height / 520);
  for (const Surface& surface : frame.surfaces) {
    if (surface.flat) draw_outline(page, surface, view, IM_COL32(26, 30, 38, 255), thickness);
  }
  for (const Surface& ghost : frame.ghosts) {
    draw_outline(page, ghost, view, IM_COL32(115, 122, 133, 220), std::max(1.0F, 0.7F * thickness));
  }
}

}  // namespace render
