// Keys of the pins of a body.
#include "app/scene/keys/motion.h"
#include "app/scene/keys/where.h"

namespace app {

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
  append(table, motion_keys<pin_of, &sim::Pin::motion, 2>("body[].pin[].motion", "How the pinned nodes are moved."));
  return table;
}

}  // namespace app
