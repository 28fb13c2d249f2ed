// The elements of a plane body in a diagram.
#pragma once

#include <functional>

#include "app/exhibit/body.h"
#include "render/sheet.h"

namespace app {

// Corners of the elements at x (2 x nodes), filled with the colour of each element and edged.
void add_elements(const sim::Mesh& mesh, const Eigen::MatrixXd& x, const std::function<std::array<int, 3>(int)>& colour,
                  bool edges, render::Diagram& diagram);

// Corners of one element, 2 x corners.
Eigen::MatrixXd corners(const sim::Mesh& mesh, int element, const Eigen::MatrixXd& x);

// The outline of a plane mesh.
void add_outline(const sim::Mesh& mesh, const Eigen::MatrixXd& x, render::Ink ink, render::Diagram& diagram);

}  // namespace app
