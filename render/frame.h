// What one picture shows: plain data, no handles, to be filled in one thread and drawn in another.
// Lengths are in the scene's unit (m), angles in degrees, colours in sRGB.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/sheet.h"

namespace render {

using Point = std::array<float, 3>;   // x, y, z; z = 0 in a 2D scene
using Colour = std::array<float, 3>;  // red, green, blue in sRGB, 0 to 1

struct Camera {
  Point eye{0, 0, 5};
  Point target{0, 0, 0};
  Point up{0, 1, 0};
  float field_of_view = 35;   // degrees, vertical; perspective only
  bool orthographic = false;  // parallel projection: what 2D scenes take
  float height = 2;           // visible height at the target; orthographic only
};

// How values become colours, shared by all surfaces that carry values; drawn as the legend.
struct ColourScale {
  std::string map = "viridis";  // one of colour_map_names() in render/colour_map.h
  float low = 0;
  float high = 1;
  std::string label;  // "von Mises stress"
  std::string unit;   // "kPa"; may be empty
};

// How bodies take the light.
enum class Finish {
  rubber,  // dense, with a dim broad gloss
  jelly,   // glossy, light shines through
};

// A triangulated body, or what is visible of it. n vertices, m triangles.
struct Surface {
  std::string name;                      // for messages
  std::vector<float> positions;          // 3 n: x, y, z of each vertex
  std::vector<std::uint32_t> triangles;  // 3 m: vertices, counter-clockwise seen from outside
  std::vector<float> normals;            // 3 n, unit; empty: smooth normals are computed, sharp at creases
  std::vector<float> rest;               // 3 n: where creases are looked for; empty: positions
  float crease = 40;                     // degrees between neighbouring triangles of the rest shape
  Colour colour{0.80F, 0.33F, 0.25F};    // base colour, where there are no values
  std::vector<float> values;             // n, coloured by Frame::scale; empty: base colour
  std::vector<std::uint32_t> edges;      // pairs of vertices: element edges, drawn when Look::wireframe is set
  std::vector<std::uint32_t> outline;    // pairs of vertices: the boundary of a flat body
  Finish finish = Finish::rubber;
  bool shadow = true;  // casts shadows, and lies in those of others
  bool round = false;  // drawn curved between smooth neighbours, where triangles are few
  bool flat = false;   // a 2D body: drawn in its plain colour with its outline, without light
};

struct Ground {
  Point point{0, 0, 0};
  Point normal{0, 1, 0};
};

struct PlaneObstacle {
  Point point{0, 0, 0};
  Point normal{0, 1, 0};
};

struct SphereObstacle {
  Point centre{0, 0, 0};
  float radius = 1;
};

struct Arrow {
  Point from{0, 0, 0};
  Point to{0, 0, 0};
  Colour colour{0.10F, 0.30F, 0.60F};
};

// A dot of fixed size on the screen: a pinned node.
struct Marker {
  Point at{0, 0, 0};
  Colour colour{0.13F, 0.16F, 0.20F};
};

// Text anchored above a point, or below it: the name of a body.
struct Label {
  Point at{0, 0, 0};
  std::string text;
  bool below = false;
};

struct Series {
  std::string name;
  std::vector<float> values;  // one per time of the strip; non-finite values leave a gap
};

// Quantities over time, in a small plot at the lower edge.
struct Strip {
  std::string title;         // "energy"
  std::string unit;          // "J"
  std::vector<float> times;  // s, increasing
  std::vector<Series> series;
  float until = 0;  // right end of the time axis, s; the last time if that is later
};

enum class Background {
  studio,  // light gradient: 3D scenes
  paper,   // white: figures, 2D scenes
};

// What is shown, and how much it may cost.
struct Look {
  Background background = Background::studio;
  bool wireframe = false;    // element edges of the surfaces
  bool shadow = true;        // of bodies and obstacles, on the ground and on each other
  bool occlusion = true;     // darkening in creases and near contacts
  bool legend = true;        // of Frame::scale, when a surface carries values
  bool axes = false;         // ticks along the left and lower edges; orthographic cameras only
  bool scale_bar = false;    // a bar of round length; orthographic cameras only
  std::string length = "m";  // unit beside ticks and scale bar
  bool lecture = false;      // large letters and thick dark lines, to be read from the last row
};

struct Frame {
  Camera camera;
  std::array<double, 3> origin{0, 0, 0};  // m: what is 0 here, in the scene; numbers at axes are the scene's
  std::vector<Surface> surfaces;
  std::vector<Surface> ghosts;       // translucent, without shadow: rest shapes
  std::optional<ColourScale> scale;  // needed when a surface carries values
  std::optional<Ground> ground;      // fades into the background
  std::vector<PlaneObstacle> planes;
  std::vector<SphereObstacle> spheres;
  std::vector<Arrow> arrows;
  std::vector<Marker> markers;
  std::vector<Label> labels;
  std::vector<Strip> strips;
  std::optional<Sheet> sheet;
  std::string title;    // upper left; lines are parted by \n
  std::string caption;  // lower left
  Look look;
};

}  // namespace render
