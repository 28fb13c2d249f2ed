// Keys of the tractions on a body.
#include "app/scene/keys/where.h"

namespace app {

std::vector<Key> load_keys() {
  std::vector<Key> table = {{.path = "body[].traction[]",
                             .kind = Kind::list,
                             .meaning = "A load on the boundary that keeps its direction.",
                             .binding = length<body_of, &sim::Body::tractions>}};
  append(table, where_keys<traction_of, &sim::Traction::where>(
                    {"body[].traction[].box", "body[].traction[].sphere", "body[].traction[].group"},
                    {"The boundary facets inside a box at rest: [lowest corner, highest corner]. For a membrane these "
                     "are its faces, or its edges where no face is inside.",
                     "The boundary facets inside a sphere at rest: [centre, radius].",
                     "The boundary facets of a group of the mesh."}));
  append(table, {{.path = "body[].traction[].value",
                  .kind = Kind::point,
                  .unit = "Pa",
                  .required = true,
                  .meaning = "Force per area at rest.",
                  .binding = field<traction_of, &sim::Traction::value>},
                 {.path = "body[].traction[].ramp",
                  .kind = Kind::number,
                  .unit = "s",
                  .range = at_least(0),
                  .meaning = "Time in which the load rises smoothly from zero to its value.",
                  .binding = field<traction_of, &sim::Traction::ramp>}});
  return table;
}

}  // namespace app
