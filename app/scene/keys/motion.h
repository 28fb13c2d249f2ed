// The keys of a motion by keyframes.
#pragma once

#include "app/scene/keys/binding.h"

namespace app {

// Of the std::vector<sim::Keyframe> owner(document, indices).*motion, which index `depth` counts in.
template <auto owner, auto motion, int depth>
std::vector<Key> motion_keys(std::string_view path, std::string_view meaning) {
  constexpr auto keyframe_of = [](auto& d, const Indices& i) -> auto& {
    return (owner(d, i).*motion)[i[depth]];
  };
  std::vector<Key> table = below(
      path, {{"keyframes[]", Kind::list, length<owner, motion>,
              "Pairs [time, pose] in the order of their times; from one pose to the next the motion is linear."},
             {"keyframes[].0", Form(Kind::number, "s", at_least(0)).needed(), field<keyframe_of, &sim::Keyframe::t>,
              "Time of the pose."},
             {"keyframes[].1", Kind::table, {}, "The pose: the rest position is rotated, then translated."},
             {"keyframes[].1.translate", Form(Kind::point, "m"), field<keyframe_of, &sim::Keyframe::translate>,
              "Displacement."},
             {"keyframes[].1.rotate", Kind::table, {}, "Rotation."},
             {"keyframes[].1.rotate.axis", Kind::axis, field<keyframe_of, &sim::Keyframe::axis>, "Axis of rotation."},
             {"keyframes[].1.rotate.centre", Form(Kind::point, "m"), field<keyframe_of, &sim::Keyframe::centre>,
              "Point on the axis."},
             {"keyframes[].1.rotate.degrees", Form(Kind::number, "degrees"),
              field<keyframe_of, &sim::Keyframe::degrees>, "Angle, right-handed about the axis."}});
  table.insert(table.begin(), {path, Kind::table, {}, meaning});
  return table;
}

}  // namespace app
