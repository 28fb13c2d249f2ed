// Regular meshes of rectangles, boxes and sheets.
#pragma once

#include <Eigen/Core>
#include <array>

#include "sim/mesh/input_error.h"
#include "sim/mesh/mesh.h"

namespace sim {

// All of them: the shape spans [0, L] along every axis; grid planes lie at x = L s^g, s = i/cells, so that a grading
// g > 1 clusters cells towards the low end. Middle nodes of quadratic elements lie half-way between the corners.
// Groups with nodes and facets: "left", "right" (x = 0, L), "bottom", "top" (y) and, for a box, "back", "front" (z).
// Cells are split into simplices symmetrically: every other cell is the mirror image of its neighbour, so triangles
// have alternating diagonals and a mesh with even cell counts has the symmetries of its shape.
// Throw InputError with key mesh.cells, mesh.size, mesh.grading or mesh.element.

// How many elements of this kind a cell is cut into.
int elements_per_cell(ElementKind kind);

// Elements of dimension 2, in the plane.
Mesh generate_rectangle(const Eigen::Vector2d& lengths, std::array<int, 2> cells, const Eigen::Vector2d& grading,
                        ElementKind kind);
// Elements of dimension 3.
Mesh generate_box(const Eigen::Vector3d& lengths, std::array<int, 3> cells, const Eigen::Vector3d& grading,
                  ElementKind kind);
// Membranes in space, at z = 0.
Mesh generate_sheet(const Eigen::Vector2d& lengths, std::array<int, 2> cells, const Eigen::Vector2d& grading,
                    ElementKind kind);

}  // namespace sim
