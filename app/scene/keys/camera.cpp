// Keys of [camera].
#include "app/scene/keys/binding.h"

namespace app {
namespace {

constexpr auto camera_of = [](auto& d, const Indices&) -> auto& {
  return d.camera;
};
constexpr auto pose_of = [](auto& d, const Indices& i) -> auto& {
  return d.camera.keyframes[i[0]];
};

std::vector<Key> place_keys() {
  return {
      {.path = "camera", .kind = Kind::table, .meaning = "From where the scene is seen."},
      {.path = "camera.eye",
       .kind = Kind::point,
       .unit = "m",
       .dimension = 3,
       .absent = "where all bodies are seen at all times",
       .meaning = "Position of the camera.",
       .binding = field<camera_of, &Camera::eye>},
      {.path = "camera.target",
       .kind = Kind::point,
       .unit = "m",
       .absent = "the middle of what is seen",
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
       .absent = "all bodies are seen at all times",
       .meaning = "Height of the part of the plane that is seen.",
       .binding = field<camera_of, &Camera::height>},
  };
}

std::vector<Key> motion_keys() {
  return {
      {.path = "camera.orbit",
       .kind = Kind::number,
       .unit = "degrees/s",
       .dimension = 3,
       .meaning = "Speed at which the camera turns about camera.up through the target, right-handed.",
       .binding = field<camera_of, &Camera::orbit>},
      {.path = "camera.follow",
       .kind = Kind::text,
       .absent = "none",
       .meaning = "Name of the body that the camera moves along with.",
       .binding = {[](const Document& d, const Indices&) {
                     return d.camera.follow.empty() ? std::nullopt : std::optional<Value>(d.camera.follow);
                   },
                   [](Document& d, const Indices&, const Value& name) { from_value(name, d.camera.follow); }}},
      {.path = "camera.keyframes[]",
       .kind = Kind::list,
       .meaning = "Pairs [time, pose] in the order of their times; the camera leaves and reaches each pose gently.",
       .binding = length<camera_of, &Camera::keyframes>},
      {.path = "camera.keyframes[].0",
       .kind = Kind::number,
       .unit = "s",
       .range = at_least(0),
       .required = true,
       .meaning = "Time of the pose.",
       .binding = field<pose_of, &CameraPose::t>},
      {.path = "camera.keyframes[].1",
       .kind = Kind::table,
       .meaning = "The pose, relative to where the other keys place the camera."},
      {.path = "camera.keyframes[].1.turn",
       .kind = Kind::number,
       .unit = "degrees",
       .dimension = 3,
       .meaning = "Angle by which the camera is turned about camera.up through the target, right-handed.",
       .binding = field<pose_of, &CameraPose::turn>},
      {.path = "camera.keyframes[].1.tilt",
       .kind = Kind::number,
       .unit = "degrees",
       .range = between(-180, 180),
       .dimension = 3,
       .meaning = "Angle by which the camera is raised about the target; it ends short of straight above and below.",
       .binding = field<pose_of, &CameraPose::tilt>},
      {.path = "camera.keyframes[].1.zoom",
       .kind = Kind::number,
       .range = between(1e-3, 1e3),
       .meaning = "Magnification: 2 shows everything twice as large.",
       .binding = field<pose_of, &CameraPose::zoom>},
  };
}

}  // namespace

std::vector<Key> camera_keys() {
  std::vector<Key> table = place_keys();
  append(table, motion_keys());
  return table;
}

}  // namespace app
