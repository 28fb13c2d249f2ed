// Keys of [camera] and [look].
#include "app/keys/binding.h"
#include "app/keys/choices.h"

namespace app {
namespace {

constexpr auto camera_of = [](auto& d, const Indices&) -> auto& {
  return d.camera;
};
constexpr auto look_of = [](auto& d, const Indices&) -> auto& {
  return d.look;
};

std::vector<Key> camera_keys() {
  return {
      {.path = "camera", .kind = Kind::table, .meaning = "From where the scene is seen."},
      {.path = "camera.eye",
       .kind = Kind::point,
       .unit = "m",
       .dimension = 3,
       .absent = "where all bodies are seen",
       .meaning = "Position of the camera.",
       .binding = field<camera_of, &Camera::eye>},
      {.path = "camera.target",
       .kind = Kind::point,
       .unit = "m",
       .absent = "the middle of the bodies",
       .meaning = "Point in the middle of the picture.",
       .binding = field<camera_of, &Camera::target>},
      {.path = "camera.up",
       .kind = Kind::direction,
       .dimension = 3,
       .meaning = "Direction that is up in the picture.",
       .binding = field<camera_of, &Camera::up>},
      {.path = "camera.fov",
       .kind = Kind::number,
       .unit = "degrees",
       .range = between(1, 150),
       .dimension = 3,
       .meaning = "Vertical opening angle.",
       .binding = field<camera_of, &Camera::fov>},
      {.path = "camera.height",
       .kind = Kind::number,
       .unit = "m",
       .range = above(0),
       .dimension = 2,
       .absent = "all bodies are seen",
       .meaning = "Height of the part of the plane that is seen.",
       .binding = field<camera_of, &Camera::height>},
  };
}

}  // namespace

std::vector<Key> look_keys() {
  std::vector<Key> table = camera_keys();
  const std::vector<Key> look = {
      {.path = "look", .kind = Kind::table, .meaning = "What the picture shows."},
      {.path = "look.colour",
       .kind = Kind::choice,
       .choices = colour_names,
       .meaning =
           "Colours of the bodies: \"plain\", or by von Mises stress, largest principal stretch, energy density, or "
           "J = det F.",
       .binding = field<look_of, &Look::colour>},
      {.path = "look.range",
       .kind = Kind::numbers,
       .unit = "of the values",
       .size = {2, 2},
       .absent = "from the values",
       .meaning = "Values at the two ends of the colour map.",
       .binding = field<look_of, &Look::range>},
      {.path = "look.caption",
       .kind = Kind::text,
       .meaning = "Text below the picture; {t}, {frame}, {step}, {energy}, {iterations} stand for their values.",
       .binding = field<look_of, &Look::caption>},
      {.path = "look.wireframe",
       .kind = Kind::boolean,
       .meaning = "Draw the edges of the elements.",
       .binding = field<look_of, &Look::wireframe>},
      {.path = "look.ground",
       .kind = Kind::boolean,
       .dimension = 3,
       .meaning = "Draw a floor that takes the shadows. It is a picture only: what holds bodies is an obstacle.",
       .binding = field<look_of, &Look::ground>},
      {.path = "look.ground_height",
       .kind = Kind::number,
       .unit = "m",
       .dimension = 3,
       .absent = "below the lowest body",
       .meaning = "Height of the floor along camera.up.",
       .binding = field<look_of, &Look::ground_height>},
  };
  append(table, look);
  return table;
}

}  // namespace app
