// Keys of a body's mesh.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto mesh_of = [](auto& d, const Indices& i) -> auto& {
  return d.meshes[i[0]];
};

// The lengths of one of the generators.
template <MeshSource source>
constexpr Binding generator = {[](const Document& d, const Indices& i) {
                                 const MeshSpec& mesh = mesh_of(d, i);
                                 return mesh.source == source ? std::optional<Value>(mesh.lengths) : std::nullopt;
                               },
                               [](Document& d, const Indices& i, const Value& value) {
                                 mesh_of(d, i).source = source;
                                 from_value(value, mesh_of(d, i).lengths);
                               }};

constexpr Binding file = {[](const Document& d, const Indices& i) {
                            const MeshSpec& mesh = mesh_of(d, i);
                            return mesh.source == MeshSource::file ? std::optional<Value>(to_value(mesh.file))
                                                                   : std::nullopt;
                          },
                          [](Document& d, const Indices& i, const Value& value) {
                            mesh_of(d, i).source = MeshSource::file;
                            from_value(value, mesh_of(d, i).file);
                          }};

// Lists that a mesh file does without.
template <auto member>
constexpr Binding per_axis = {[](const Document& d, const Indices& i) {
                                const auto& list = mesh_of(d, i).*member;
                                return list.empty() ? std::nullopt : std::optional<Value>(to_value(list));
                              },
                              field<mesh_of, member>.set};

std::vector<Key> generator_keys() {
  return {
      {.path = "body[].mesh",
       .kind = Kind::table,
       .required = true,
       .meaning = "Nodes and elements of the body at rest."},
      {.path = "body[].mesh.box",
       .kind = Kind::numbers,
       .unit = "m",
       .range = above(0),
       .size = {3, 3},
       .absent = "another source",
       .meaning = "A box from the origin to these lengths.",
       .binding = generator<MeshSource::box>},
      {.path = "body[].mesh.rectangle",
       .kind = Kind::numbers,
       .unit = "m",
       .range = above(0),
       .size = {2, 2},
       .absent = "another source",
       .meaning = "A rectangle in a plane scene, from the origin to these lengths.",
       .binding = generator<MeshSource::rectangle>},
      {.path = "body[].mesh.sheet",
       .kind = Kind::numbers,
       .unit = "m",
       .range = above(0),
       .size = {2, 2},
       .absent = "another source",
       .meaning = "A rectangular membrane in space, at z = 0.",
       .binding = generator<MeshSource::sheet>},
      {.path = "body[].mesh.file",
       .kind = Kind::text,
       .absent = "another source",
       .meaning = "A mesh file (.msh, .node, .obj); its path is relative to the scene file.",
       .binding = file},
      {.path = "body[].mesh.cells",
       .kind = Kind::integers,
       .range = between(1, 10000),
       .absent = "needed with box, rectangle, sheet",
       .meaning = "Number of cells along each axis of a generated mesh; each cell is cut into triangles or tets where "
                  "the element is one.",
       .binding = per_axis<&MeshSpec::cells>},
      {.path = "body[].mesh.grading",
       .kind = Kind::numbers,
       .range = {.low = 0.1, .high = 10},
       .absent = "1 for every axis",
       .meaning = "For each axis of a generated mesh, x = length s^grading with s spaced evenly from 0 to 1: above 1, "
                  "cells crowd towards the low end.",
       .binding = per_axis<&MeshSpec::grading>},
  };
}

}  // namespace

std::vector<Key> mesh_keys() {
  std::vector<Key> table = generator_keys();
  const std::vector<Key> shared = {
      {.path = "body[].mesh.element",
       .kind = Kind::choice,
       .choices = element_names,
       .absent = "as the file says; tet4 in a box, else tri3",
       .meaning = "Element of the mesh. A linear mesh file can be read as its quadratic kind.",
       .binding = field<mesh_of, &MeshSpec::element>},
      {.path = "body[].mesh.refine",
       .kind = Kind::integer,
       .range = between(0, 8),
       .meaning = "How many times every element is split into 4 (plane) or 8.",
       .binding = field<mesh_of, &MeshSpec::refine>},
      {.path = "body[].mesh.scale",
       .kind = Kind::number,
       .range = above(0),
       .meaning = "Factor on every length; applied first.",
       .binding = field<mesh_of, &MeshSpec::scale>},
      {.path = "body[].mesh.rotate", .kind = Kind::table, .meaning = "Rotation about the origin; applied second."},
      {.path = "body[].mesh.rotate.axis",
       .kind = Kind::axis,
       .meaning = "Axis of rotation.",
       .binding = field<mesh_of, &MeshSpec::axis>},
      {.path = "body[].mesh.rotate.degrees",
       .kind = Kind::number,
       .unit = "degrees",
       .meaning = "Angle, right-handed about the axis.",
       .binding = field<mesh_of, &MeshSpec::degrees>},
      {.path = "body[].mesh.translate",
       .kind = Kind::point,
       .unit = "m",
       .meaning = "Displacement of the mesh; applied last.",
       .binding = field<mesh_of, &MeshSpec::translate>},
  };
  append(table, shared);
  return table;
}

}  // namespace app
