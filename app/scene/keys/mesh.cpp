// Keys of the meshes of bodies and obstacles.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto mesh_of = [](auto& d, const Indices& i) -> auto& {
  return d.meshes[i[0]];
};
constexpr auto obstacle_mesh_of = [](auto& d, const Indices& i) -> auto& {
  return d.obstacle_meshes[i[0]].spec;
};

// The lengths of one of the generators.
template <auto owner, MeshSource source>
constexpr Binding generator = {[](const Document& d, const Indices& i) {
                                 const MeshSpec& mesh = owner(d, i);
                                 return mesh.source == source ? std::optional<Value>(mesh.lengths) : std::nullopt;
                               },
                               [](Document& d, const Indices& i, const Value& value) {
                                 owner(d, i).source = source;
                                 from_value(value, owner(d, i).lengths);
                               }};

template <auto owner, MeshSource source>
constexpr Binding mesh_file = {[](const Document& d, const Indices& i) {
                                 const MeshSpec& mesh = owner(d, i);
                                 return mesh.source == source ? std::optional<Value>(to_value(mesh.file))
                                                              : std::nullopt;
                               },
                               [](Document& d, const Indices& i, const Value& value) {
                                 owner(d, i).source = source;
                                 from_value(value, owner(d, i).file);
                               }};

constexpr Binding fill_size = {[](const Document& d, const Indices& i) {
                                 const double size = mesh_of(d, i).size;
                                 return size == 0 ? std::nullopt : std::optional<Value>(size);
                               },
                               field<mesh_of, &MeshSpec::size>.set};

constexpr Binding worn_skin = {[](const Document& d, const Indices& i) {
                                 const MeshSpec& mesh = mesh_of(d, i);
                                 if (!mesh.skin_file.empty()) return std::optional<Value>(to_value(mesh.skin_file));
                                 return mesh.wears_surface ? std::optional<Value>(true) : std::nullopt;
                               },
                               [](Document& d, const Indices& i, const Value& value) {
                                 MeshSpec& mesh = mesh_of(d, i);
                                 const bool* const wears = std::get_if<bool>(&value);
                                 mesh.wears_surface = wears != nullptr && *wears;
                                 mesh.skin_file = wears == nullptr ? std::get<std::string>(value) : "";
                               }};

// 0 stands for nodes that coincide; without the key none are joined.
constexpr Binding merge = {[](const Document& d, const Indices& i) {
                             const double distance = mesh_of(d, i).merge;
                             return distance < 0 ? std::nullopt : std::optional<Value>(distance);
                           },
                           field<mesh_of, &MeshSpec::merge>.set};

// Lists that a mesh file does without.
template <auto owner, auto member>
constexpr Binding per_axis = {[](const Document& d, const Indices& i) {
                                const auto& list = owner(d, i).*member;
                                return list.empty() ? std::nullopt : std::optional<Value>(to_value(list));
                              },
                              field<owner, member>.set};

// Where a mesh stands: an obstacle that is none has no such key.
template <auto owner, auto member>
constexpr Binding placed = {[](const Document& d, const Indices& i) {
                              return owner(d, i).source == MeshSource::none ? std::nullopt
                                                                            : field<owner, member>.get(d, i);
                            },
                            field<owner, member>.set};

// What both may be generated from, or read.
template <auto owner>
std::vector<Key> source_keys() {
  return {
      {"box", Form(Kind::numbers, "m", above(0)).of_size(3, 3).otherwise("another source"),
       generator<owner, MeshSource::box>, "A box from the origin to these lengths."},
      {"rectangle", Form(Kind::numbers, "m", above(0)).of_size(2, 2).otherwise("another source"),
       generator<owner, MeshSource::rectangle>, "A rectangle in a plane scene, from the origin to these lengths."},
      {"sheet", Form(Kind::numbers, "m", above(0)).of_size(2, 2).otherwise("another source"),
       generator<owner, MeshSource::sheet>, "A rectangular membrane in space, at z = 0."},
  };
}

template <auto owner>
std::vector<Key> cell_keys() {
  return {
      {"cells", Form(Kind::integers, "", between(1, 10000)).otherwise("needed with box, rectangle, sheet"),
       per_axis<owner, &MeshSpec::cells>,
       "Number of cells along each axis of a generated mesh; each cell is cut into triangles or tets where the element "
       "is one."},
      {"grading", Form(Kind::numbers, "", between(0.1, 10)).otherwise("1 for every axis"),
       per_axis<owner, &MeshSpec::grading>,
       "For each axis of a generated mesh, x = length s^grading with s spaced evenly from 0 to 1: above 1, cells crowd "
       "towards the low end."},
  };
}

// Where the mesh stands.
template <auto owner>
std::vector<Key> placement_keys() {
  return {
      {"refine", Form(Kind::integer, "", between(0, 8)), placed<owner, &MeshSpec::refine>,
       "How many times every element is split into 4 (plane) or 8."},
      {"scale", Form(Kind::number, "", above(0)), placed<owner, &MeshSpec::scale>,
       "Factor on every length; applied first."},
      {"rotate", Kind::table, {}, "Rotation about the origin; applied second."},
      {"rotate.axis", Kind::axis, placed<owner, &MeshSpec::axis>, "Axis of rotation."},
      {"rotate.degrees", Form(Kind::number, "degrees"), placed<owner, &MeshSpec::degrees>,
       "Angle, right-handed about the axis."},
      {"translate", Form(Kind::point, "m"), placed<owner, &MeshSpec::translate>,
       "Displacement of the mesh; applied last."},
  };
}

}  // namespace

std::vector<Key> mesh_keys() {
  std::vector<Key> table = source_keys<mesh_of>();
  append(table,
         {{"file", Form(Kind::text).otherwise("another source"), mesh_file<mesh_of, MeshSource::file>,
           "A mesh file (app/mesh/README.md lists the formats); its path is relative to the scene file."},
          {"surface", Form(Kind::text).otherwise("another source"), mesh_file<mesh_of, MeshSource::surface>,
           "A file of triangles around a solid, which is filled with tets; its path is relative to the scene file. "
           "Holes are closed, and what shells share is filled once."},
          {"size", Form(Kind::number, "m", above(0)).otherwise("needed with surface"), fill_size,
           "About the length of the edges that fill a surface, when it has been scaled. What is thinner is lost."},
          {"skin", Form(Kind::switch_or_text).otherwise("the body's own surface"), worn_skin,
           "What the picture shows of a body of tets: true for the surface that was filled, or a file of triangles, "
           "which the body carries along. Nothing else changes."}});
  append(table, cell_keys<mesh_of>());
  append(table,
         {{"element", Form(Kind::choice).of(element_names).otherwise("as the file says; tet4 in a box, else tri3"),
           field<mesh_of, &MeshSpec::element>,
           "Element of the mesh. A linear mesh file can be read as its quadratic kind."},
          {"merge", Form(Kind::joining, "m", above(0)).otherwise("not joined"), merge,
           "Joins nodes that stand at one place (true) or closer than this distance, in a mesh that is cut where it "
           "should not be."},
          {"space", Form(Kind::integer, "", between(2, 3)), field<mesh_of, &MeshSpec::space>,
           "3: a plane mesh is a membrane in space, and the scene in 3D."}});
  append(table, placement_keys<mesh_of>());
  table = below("body[].mesh", table);
  table.insert(table.begin(), {"body[].mesh",
                               Form(Kind::table).tells(Effect::restart).needed(),
                               {},
                               "Nodes and elements of the body at rest."});
  return table;
}

std::vector<Key> obstacle_mesh_keys() {
  std::vector<Key> table = source_keys<obstacle_mesh_of>();
  append(table,
         {{"file", Form(Kind::text).otherwise("another source"), mesh_file<obstacle_mesh_of, MeshSource::file>,
           "A mesh file, of which the surface counts, closed or open; in a plane scene also an MSH file of lines. "
           "Its path is relative to the scene file."}});
  append(table, cell_keys<obstacle_mesh_of>());
  append(table, placement_keys<obstacle_mesh_of>());
  table = below("obstacle[].mesh", table);
  table.insert(table.begin(), {"obstacle[].mesh",
                               Form(Kind::table).tells(Effect::restart).otherwise("another shape"),
                               {},
                               "A surface: no body passes it, from either side."});
  return table;
}

}  // namespace app
