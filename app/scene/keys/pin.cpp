// Keys of the pins of a body.
#include "app/scene/keys/where.h"

namespace app {
namespace {

constexpr auto keyframe_of = [](auto& d, const Indices& i) -> auto& {
  return pin_of(d, i).motion[i[2]];
};

std::vector<Key> pin_motion_keys() {
  return {
      {"body[].pin[].motion", Kind::table, {}, "How the pinned nodes are moved."},
      {"body[].pin[].motion.keyframes[]", Kind::list, length<pin_of, &sim::Pin::motion>,
       "Pairs [time, pose] in the order of their times; from one pose to the next the motion is linear."},
      {"body[].pin[].motion.keyframes[].0", Form(Kind::number, "s", at_least(0)).needed(),
       field<keyframe_of, &sim::Keyframe::t>, "Time of the pose."},
      {"body[].pin[].motion.keyframes[].1",
       Kind::table,
       {},
       "The pose: the rest position is rotated, then translated."},
      {"body[].pin[].motion.keyframes[].1.translate", Form(Kind::point, "m"),
       field<keyframe_of, &sim::Keyframe::translate>, "Displacement."},
      {"body[].pin[].motion.keyframes[].1.rotate", Kind::table, {}, "Rotation."},
      {"body[].pin[].motion.keyframes[].1.rotate.axis", Kind::axis, field<keyframe_of, &sim::Keyframe::axis>,
       "Axis of rotation."},
      {"body[].pin[].motion.keyframes[].1.rotate.centre", Form(Kind::point, "m"),
       field<keyframe_of, &sim::Keyframe::centre>, "Point on the axis."},
      {"body[].pin[].motion.keyframes[].1.rotate.degrees", Form(Kind::number, "degrees"),
       field<keyframe_of, &sim::Keyframe::degrees>, "Angle, right-handed about the axis."},
  };
}

}  // namespace

std::vector<Key> pin_keys() {
  std::vector<Key> table = {
      {"body[].pin[]", Kind::list, length<body_of, &sim::Body::pins>, "Nodes whose motion is prescribed."}};
  append(table, where_keys<pin_of, &sim::Pin::where>(
                    {"body[].pin[].box", "body[].pin[].sphere", "body[].pin[].group", "body[].pin[].dimension"},
                    {"The nodes inside a box at rest: [lowest corner, highest corner].",
                     "The nodes inside a sphere at rest: [centre, radius].", "The nodes of a group of the mesh.",
                     "Of the group: 0 nodes, 1 edges, 2 faces, 3 solids. Needed where several groups have its name."}));
  append(table, {{"body[].pin[].axes", Kind::axes, field<pin_of, &sim::Pin::axes>,
                  "The components that are prescribed; the others are free."},
                 {"body[].pin[].release", Form(Kind::number, "s", at_least(0)).otherwise("never"),
                  field<pin_of, &sim::Pin::release>, "Time at which the nodes are let go."},
                 {"body[].pin[].at_start", Kind::boolean, field<pin_of, &sim::Pin::at_start>,
                  "Hold the nodes where the body starts, instead of where it is at rest."}});
  append(table, pin_motion_keys());
  return table;
}

}  // namespace app
