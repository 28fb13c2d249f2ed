// Keys of the loads on a body.
#include "app/scene/keys/where.h"

namespace app {
namespace {

std::vector<Key> traction_keys() {
  std::vector<Key> table = {{"body[].traction[]", Kind::list, length<loads_of, &sim::BodyLoads::tractions>,
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

std::vector<Key> pressure_keys() {
  std::vector<Key> table = {
      {"body[].pressure[]", Kind::list, length<loads_of, &sim::BodyLoads::pressures>,
       "A load normal to the surface, as the body moves: it presses on a solid, blows up a closed "
       "membrane and acts along the normals of an open one's faces."}};
  append(table, where_keys<pressure_of, &sim::Pressure::where>(
                    {"body[].pressure[].box", "body[].pressure[].sphere", "body[].pressure[].group",
                     "body[].pressure[].dimension"},
                    {"The boundary facets, or faces of a membrane, inside a box at rest: [lowest corner, highest "
                     "corner]. Without box, sphere and group: all of them.",
                     "Those inside a sphere at rest: [centre, radius].", "Those of a group of the mesh.",
                     "Of the group: 0 nodes, 1 edges, 2 faces, 3 solids. Needed where several groups have its name."}));
  append(table,
         {{"body[].pressure[].value", Form(Kind::number, "Pa").needed(), field<pressure_of, &sim::Pressure::value>,
           "Force per area as it is; below 0 it pulls."},
          {"body[].pressure[].ramp", Form(Kind::number, "s", at_least(0)), field<pressure_of, &sim::Pressure::ramp>,
           "Time in which the pressure rises smoothly from zero to its value."}});
  return table;
}

std::vector<Key> point_force_keys() {
  return {
      {"body[].force[]", Kind::list, length<loads_of, &sim::BodyLoads::forces>,
       "A force at a point of the body that keeps its direction."},
      {"body[].force[].at", Form(Kind::point, "m").needed(), field<force_of, &sim::PointForce::at>,
       "The point, at rest."},
      {"body[].force[].value", Form(Kind::point, "N").needed(), field<force_of, &sim::PointForce::value>, "The force."},
      {"body[].force[].ramp", Form(Kind::number, "s", at_least(0)), field<force_of, &sim::PointForce::ramp>,
       "Time in which the force rises smoothly from zero to its value."}};
}

}  // namespace

std::vector<Key> load_keys() {
  std::vector<Key> table = traction_keys();
  append(table, pressure_keys());
  append(table, point_force_keys());
  return table;
}

}  // namespace app
