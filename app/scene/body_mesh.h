// The mesh of a body: how a scene describes it, and the sim::Mesh that comes of it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/scene/skin.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/mesh.h"
#include "sim/scene.h"

namespace app {

enum class MeshSource { none, box, rectangle, sheet, file, surface };

// `mesh = {...}` of a body. A generator spans [0, length] per axis.
struct MeshSpec {
  MeshSource source = MeshSource::none;
  std::vector<double> lengths;      // m, one per axis: 3 for a box, 2 for a rectangle or sheet
  std::filesystem::path file;       // path of the mesh file or the surface, from the current folder
  double size = 0;                  // m, about the length of the edges that fill a surface
  bool wears_surface = false;       // the surface that was filled is drawn
  std::filesystem::path skin_file;  // or this one
  std::vector<int> cells;           // one per axis
  std::vector<double> grading;  // per axis, x = length s^grading with s in [0, 1]: > 1 clusters cells at the low end
  std::string element;          // empty: what the file holds, tri3 or tet4 of a generator
  double merge = -1;            // m: nodes closer than this are joined; 0: those that coincide; below 0: none
  int space = 2;                // 3: a plane mesh is a membrane in space
  int refine = 0;               // times that every element is split
  double scale = 1;             // then rotated, then translated
  sim::Vec3 axis = {0, 0, 1};   // unit; rotation about the origin
  double degrees = 0;
  sim::Vec3 translate = {0, 0, 0};   // m
  std::shared_ptr<const Skin> skin;  // made with the mesh; none: the body's own surface is drawn
};

// What the description says, not yet placed: 2D for a rectangle or a plane file that is not put into space, else 3D.
// Fills spec.element and spec.skin in. Remarks are added for what was mended. Throws sim::InputError with key "mesh..."
// (below the body's).
sim::Mesh make_mesh(MeshSpec& spec, std::vector<std::string>& remarks);

// Lifts the mesh to `dimension` (z = 0), then x = R scale X + translate.
void place_mesh(const MeshSpec& spec, int dimension, sim::Mesh& mesh);

// Number of axes that the description's lengths, cells and grading have: 3 for a box, else 2.
int axes(MeshSource source);

}  // namespace app
