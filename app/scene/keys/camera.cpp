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
      {"camera", Form(Kind::table).tells(Effect::look), {}, "From where the scene is seen."},
      {"camera.eye", Form(Kind::point, "m").only_in(3).otherwise("where all bodies are seen at all times"),
       field<camera_of, &Camera::eye>, "Position of the camera."},
      {"camera.target", Form(Kind::point, "m").otherwise("the middle of what is seen"),
       field<camera_of, &Camera::target>, "Point in the middle of the picture."},
      {"camera.up", Form(Kind::direction).only_in(3).otherwise("against gravity; y without gravity"),
       field<camera_of, &Camera::up>, "Direction that is up in the picture."},
      {"camera.fov", Form(Kind::number, "degrees", between(1, 150)).only_in(3), field<camera_of, &Camera::fov>,
       "Vertical opening angle."},
      {"camera.height", Form(Kind::number, "m", above(0)).only_in(2).otherwise("all bodies are seen at all times"),
       field<camera_of, &Camera::height>, "Height of the part of the plane that is seen."},
  };
}

std::vector<Key> motion_keys() {
  return {
      {"camera.orbit", Form(Kind::number, "degrees/s").only_in(3), field<camera_of, &Camera::orbit>,
       "Speed at which the camera turns about camera.up through the target, right-handed."},
      {"camera.follow",
       Form(Kind::text).otherwise("none"),
       {[](const Document& d, const Indices&) {
          return d.camera.follow.empty() ? std::nullopt : std::optional<Value>(d.camera.follow);
        },
        [](Document& d, const Indices&, const Value& name) { from_value(name, d.camera.follow); }},
       "Name of the body that the camera moves along with."},
      {"camera.keyframes[]", Kind::list, length<camera_of, &Camera::keyframes>,
       "Pairs [time, pose] in the order of their times; the camera leaves and reaches each pose gently."},
      {"camera.keyframes[].0", Form(Kind::number, "s", at_least(0)).needed(), field<pose_of, &CameraPose::t>,
       "Time of the pose."},
      {"camera.keyframes[].1", Kind::table, {}, "The pose, relative to where the other keys place the camera."},
      {"camera.keyframes[].1.turn", Form(Kind::number, "degrees").only_in(3), field<pose_of, &CameraPose::turn>,
       "Angle by which the camera is turned about camera.up through the target, right-handed."},
      {"camera.keyframes[].1.tilt", Form(Kind::number, "degrees", between(-180, 180)).only_in(3),
       field<pose_of, &CameraPose::tilt>,
       "Angle by which the camera is raised about the target; it ends short of straight above and below."},
      {"camera.keyframes[].1.zoom", Form(Kind::number, "", between(1e-3, 1e3)), field<pose_of, &CameraPose::zoom>,
       "Magnification: 2 shows everything twice as large."},
  };
}

}  // namespace

std::vector<Key> camera_keys() {
  std::vector<Key> table = place_keys();
  append(table, motion_keys());
  return table;
}

}  // namespace app
