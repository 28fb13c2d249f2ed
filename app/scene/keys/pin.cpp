// Keys of the pins of a body.
#include "app/scene/keys/where.h"

namespace app {
namespace {

constexpr auto keyframe_of = [](auto& d, const Indices& i) -> auto& {
  return pin_of(d, i).motion[i[2]];
};

std::vector<Key> pin_motion_keys() {
  return {
      {.path = "body[].pin[].motion", .kind = Kind::table, .meaning = "How the pinned nodes are moved."},
      {.path = "body[].pin[].motion.keyframes[]",
       .kind = Kind::list,
       .meaning = "Pairs [time, pose] in the order of their times; from one pose to the next the motion is linear.",
       .binding = length<pin_of, &sim::Pin::motion>},
      {.path = "body[].pin[].motion.keyframes[].0",
       .kind = Kind::number,
       .unit = "s",
       .range = at_least(0),
       .required = true,
       .meaning = "Time of the pose.",
       .binding = field<keyframe_of, &sim::Keyframe::t>},
      {.path = "body[].pin[].motion.keyframes[].1",
       .kind = Kind::table,
       .meaning = "The pose: the rest position is rotated, then translated."},
      {.path = "body[].pin[].motion.keyframes[].1.translate",
       .kind = Kind::point,
       .unit = "m",
       .meaning = "Displacement.",
       .binding = field<keyframe_of, &sim::Keyframe::translate>},
      {.path = "body[].pin[].motion.keyframes[].1.rotate", .kind = Kind::table, .meaning = "Rotation."},
      {.path = "body[].pin[].motion.keyframes[].1.rotate.axis",
       .kind = Kind::axis,
       .meaning = "Axis of rotation.",
       .binding = field<keyframe_of, &sim::Keyframe::axis>},
      {.path = "body[].pin[].motion.keyframes[].1.rotate.centre",
       .kind = Kind::point,
       .unit = "m",
       .meaning = "Point on the axis.",
       .binding = field<keyframe_of, &sim::Keyframe::centre>},
      {.path = "body[].pin[].motion.keyframes[].1.rotate.degrees",
       .kind = Kind::number,
       .unit = "degrees",
       .meaning = "Angle, right-handed about the axis.",
       .binding = field<keyframe_of, &sim::Keyframe::degrees>},
  };
}

}  // namespace

std::vector<Key> pin_keys() {
  std::vector<Key> table = {{.path = "body[].pin[]",
                             .kind = Kind::list,
                             .meaning = "Nodes whose motion is prescribed.",
                             .binding = length<body_of, &sim::Body::pins>}};
  append(table, where_keys<pin_of, &sim::Pin::where>(
                    {"body[].pin[].box", "body[].pin[].sphere", "body[].pin[].group"},
                    {"The nodes inside a box at rest: [lowest corner, highest corner].",
                     "The nodes inside a sphere at rest: [centre, radius].", "The nodes of a group of the mesh."}));
  append(table, {{.path = "body[].pin[].axes",
                  .kind = Kind::axes,
                  .meaning = "The components that are prescribed; the others are free.",
                  .binding = field<pin_of, &sim::Pin::axes>},
                 {.path = "body[].pin[].release",
                  .kind = Kind::number,
                  .unit = "s",
                  .range = at_least(0),
                  .absent = "never",
                  .meaning = "Time at which the nodes are let go.",
                  .binding = field<pin_of, &sim::Pin::release>}});
  append(table, pin_motion_keys());
  return table;
}

}  // namespace app
