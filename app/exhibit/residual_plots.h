// Curves of the weighted residual methods: solutions, and what a method does to what is left of the equation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/residuals/study.h"
#include "render/sheet.h"

namespace app {

// A method with n functions, as a page names and colours it.
struct MethodEntry {
  std::string method, label;
  render::Ink ink = render::Ink::black;
  std::optional<Attempt> attempt = {};  // none where it is refused
  sim::residual::Vector points = {};    // where it makes the residual zero
};

render::Stroke curve_of(const sim::residual::Function& u, render::Ink ink, bool dashed = false);

// u, dashed, and u_n.
render::Diagram solution_plot(const sim::residual::Problem& problem, const MethodEntry& entry,
                              const render::Box& place);

// Of an entry with an attempt: its residual r = L u_n - f, with the points where it is zero, the area of its square, or
// that of r times function `term`; of Ritz's method F over coefficient `term`.
render::Diagram action_plot(const sim::residual::Problem& problem, const MethodEntry& entry, Eigen::Index term,
                            const render::Box& place);

}  // namespace app
