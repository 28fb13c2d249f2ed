#include "render/check.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "render/colour_map.h"

namespace render {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::invalid_argument(what);
}

void check_finite(const std::vector<float>& numbers, std::size_t per_vertex, const std::string& what) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i])) {
      fail(what + " of vertex " + std::to_string(i / per_vertex) + " is " + std::to_string(numbers[i]) +
           ", must be finite");
    }
  }
}

void check_indices(const std::vector<std::uint32_t>& indices, std::size_t per_item, std::size_t vertices,
                   const std::string& what) {
  if (indices.size() % per_item != 0) {
    fail(what + ": " + std::to_string(indices.size()) + " indices are not a multiple of " + std::to_string(per_item));
  }
  for (const std::uint32_t index : indices) {
    if (index >= vertices) {
      fail(what + ": vertex " + std::to_string(index) + " of " + std::to_string(vertices) + " does not exist");
    }
  }
}

void check_length(const std::vector<float>& list, std::size_t wanted, const std::string& what) {
  if (!list.empty() && list.size() != wanted) {
    fail(what + ": " + std::to_string(list.size()) + " numbers where " + std::to_string(wanted) + " belong");
  }
}

void check_surface(const Surface& surface, bool has_scale) {
  const std::string who = "surface \"" + surface.name + "\": ";
  if (surface.positions.size() % 3 != 0) fail(who + "positions are not three numbers per vertex");
  const std::size_t vertices = surface.positions.size() / 3;
  check_length(surface.normals, 3 * vertices, who + "normals");
  check_length(surface.rest, 3 * vertices, who + "rest positions");
  check_length(surface.values, vertices, who + "values");
  if (!surface.values.empty() && !has_scale) fail(who + "values need the frame's colour scale");
  check_finite(surface.positions, 3, who + "position");
  check_finite(surface.normals, 3, who + "normal");
  check_finite(surface.rest, 3, who + "rest position");
  check_finite(surface.values, 1, who + "value");
  check_indices(surface.triangles, 3, vertices, who + "triangles");
  check_indices(surface.edges, 2, vertices, who + "edges");
  check_indices(surface.outline, 2, vertices, who + "outline");
}

void check_point(const Point& point, const std::string& what) {
  for (const float c : point) {
    if (!std::isfinite(c)) fail(what + " must be finite");
  }
}

void check_plane(const Point& point, const Point& normal, const std::string& what) {
  check_point(point, what + ": point");
  check_point(normal, what + ": normal");
  if (normal == Point{0, 0, 0}) fail(what + ": normal is zero");
}

void check_strip(const Strip& strip) {
  for (const float t : strip.times) {
    if (!std::isfinite(t)) fail("strip \"" + strip.title + "\": times must be finite");
  }
  for (const Series& series : strip.series) {
    if (series.values.size() != strip.times.size()) {
      fail("strip \"" + strip.title + "\": series \"" + series.name + "\" has " + std::to_string(series.values.size()) +
           " values for " + std::to_string(strip.times.size()) + " times");
    }
  }
}

}  // namespace

void check(const Frame& frame) {
  for (const Surface& surface : frame.surfaces) check_surface(surface, frame.scale.has_value());
  for (const Surface& ghost : frame.ghosts) check_surface(ghost, frame.scale.has_value());
  if (frame.scale) {
    colour_at(frame.scale->map, 0);
    if (!std::isfinite(frame.scale->low) || !std::isfinite(frame.scale->high)) {
      fail("colour scale: both ends must be finite");
    }
  }
  if (frame.ground) check_plane(frame.ground->point, frame.ground->normal, "ground");
  for (const PlaneObstacle& plane : frame.planes) check_plane(plane.point, plane.normal, "plane");
  for (const SphereObstacle& sphere : frame.spheres) {
    check_point(sphere.centre, "sphere: centre");
    if (!(sphere.radius > 0) || !std::isfinite(sphere.radius)) {
      fail("sphere: radius is " + std::to_string(sphere.radius) + ", must be above 0");
    }
  }
  for (const Arrow& arrow : frame.arrows) {
    check_point(arrow.from, "arrow: start");
    check_point(arrow.to, "arrow: end");
  }
  for (const Marker& marker : frame.markers) check_point(marker.at, "marker");
  for (const Label& label : frame.labels) check_point(label.at, "label \"" + label.text + "\"");
  for (const Strip& strip : frame.strips) check_strip(strip);
}

}  // namespace render
