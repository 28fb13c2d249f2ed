// Keys of the tractions on a body.
#include "app/scene/keys/where.h"

namespace app {

std::vector<Key> load_keys() {
  std::vector<Key> table = {{"body[].traction[]", Kind::list, length<body_of, &sim::Body::tractions>,
                             "A load on the boundary that keeps its direction."}};
  append(table, where_keys<traction_of, &sim::Traction::where>(
                    {"body[].traction[].box", "body[].traction[].sphere", "body[].traction[].group",
                     "body[].traction[].dimension"},
                    {"The boundary facets inside a box at rest: [lowest corner, highest corner]. For a membrane these "
                     "are its faces, or its edges where no face is inside.",
                     "The boundary facets inside a sphere at rest: [centre, radius].",
                     "The boundary facets of a group of the mesh.",
                     "Of the group: 0 nodes, 1 edges, 2 faces, 3 solids. Needed where several groups have its name."}));
  append(table,
         {{"body[].traction[].value", Form(Kind::point, "Pa").needed(), field<traction_of, &sim::Traction::value>,
           "Force per area at rest."},
          {"body[].traction[].ramp", Form(Kind::number, "s", at_least(0)), field<traction_of, &sim::Traction::ramp>,
           "Time in which the load rises smoothly from zero to its value."}});
  return table;
}

}  // namespace app
