#include "render/legend.h"

#include <algorithm>
#include <cmath>

#include "render/colour_map.h"
#include "render/ticks.h"

namespace render {

ImVec2 draw_legend(const Page& page, const ColourScale& scale, float bottom) {
  const float bar_width = std::round(0.9F * page.size);
  const std::string heading = scale.unit.empty() ? scale.label : scale.label + " [" + scale.unit + "]";
  const float wrap = 0.24F * page.width;
  const ImVec2 heading_size = page.measure(heading, 1, wrap);
  const float room = bottom - 4.5F * page.size - heading_size.y;  // below a title
  const float bar_height = std::round(std::clamp(0.36F * page.height, 2 * page.size, std::max(room, 2 * page.size)));
  const std::vector<double> values = ticks(scale.low, scale.high, static_cast<int>(bar_height / (2.2F * page.size)));
  const std::vector<std::string> labels = tick_labels(values);
  float widest = 0;
  for (const std::string& label : labels) widest = std::max(widest, page.measure(label, 0.9F).x);

  const float pad = 0.45F * page.size;
  const float right = page.width - page.margin;
  const float width = std::max(heading_size.x, bar_width + 0.55F * page.size + widest);
  const float left = std::round(right - width);
  const float lowest = bottom - bar_height - 0.8F * page.size;
  const float highest = heading_size.y + page.size;  // it is in the picture, whatever is below
  const float top = std::round(std::max(std::min((page.height - bar_height) / 2 + 0.8F * page.size, lowest), highest));
  const ImVec2 corner{left - pad, top - heading_size.y - 0.75F * page.size};
  page.lay_plate(corner, {right + pad, top + bar_height + 0.8F * page.size});
  page.write(left, top - heading_size.y - 0.55F * page.size, heading, Align::left, Page::ink, 1, wrap);

  const std::vector<std::uint8_t> colours = colour_table(scale.map, static_cast<int>(bar_height));
  for (int row = 0; row < static_cast<int>(bar_height); ++row) {
    const std::uint8_t* c = colours.data() + 3 * (static_cast<int>(bar_height) - 1 - row);
    const float y = top + static_cast<float>(row);
    page.list->AddRectFilled({left, y}, {left + bar_width, y + 1}, IM_COL32(c[0], c[1], c[2], 255));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double width = static_cast<double>(scale.high) - scale.low;
    const float share = width != 0 ? static_cast<float>((values[i] - scale.low) / width) : 0.5F;
    const float y = std::round(top + (1 - share) * (bar_height - 1));
    page.list->AddRectFilled({left + bar_width, y}, {left + bar_width + 0.3F * page.size, y + 1}, Page::soft_ink);
    page.write(left + bar_width + 0.5F * page.size, y - 0.45F * page.size, labels[i], Align::left, Page::ink, 0.9F);
  }
  return corner;
}

}  // namespace render
