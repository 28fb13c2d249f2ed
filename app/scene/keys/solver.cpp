// Keys of [solver].
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto solver_of = [](auto& d, const Indices&) -> auto& {
  return d.scene.solver;
};

}  // namespace

std::vector<Key> solver_keys() {
  return {
      {.path = "solver", .kind = Kind::table, .meaning = "How the equations of an implicit step are solved."},
      {.path = "solver.linear",
       .kind = Kind::choice,
       .choices = names_of<sim::LinearSolverKind>,
       .meaning = "Linear solver inside Newton's method: \"cholmod\" factorises the matrix, \"pcg\" iterates and forms "
                  "none, \"pcg-assembled\" iterates on it, \"auto\" chooses by size and by counts of iterations.",
       .binding = field<solver_of, &sim::Solver::linear>},
      {.path = "solver.tolerance",
       .kind = Kind::number,
       .unit = "body sizes/s",
       .range = inside(0, 1),
       .meaning = "Newton's method stops when max |dx|/(g h) is below it; dx is the last change of the positions, h "
                  "the step and g the integrator's share of it.",
       .binding = field<solver_of, &sim::Solver::tolerance>},
      {.path = "solver.max_iterations",
       .kind = Kind::integer,
       .range = between(1, 100000),
       .meaning = "The most Newton iterations that a stage of a step may take; solver.on_failure says what happens "
                  "where they do not suffice.",
       .binding = field<solver_of, &sim::Solver::max_iterations>},
      {.path = "solver.lag_iterations",
       .kind = Kind::integer,
       .range = between(0, 100),
       .meaning =
           "Beta damping takes its stiffness, and friction its pressure, from the beginning of the step, which costs "
           "them an order of accuracy. This many times a stage is solved again with both taken from its own solution.",
       .binding = field<solver_of, &sim::Solver::lag_iterations>},
      {.path = "solver.definiteness",
       .kind = Kind::choice,
       .choices = names_of<sim::Definiteness>,
       .meaning = "What is done to negative eigenvalues of an element's stiffness: \"clamp\" sets them to zero, "
                  "\"abs\" makes them positive, \"none\" keeps them.",
       .binding = field<solver_of, &sim::Solver::definiteness>},
      {.path = "solver.on_failure",
       .kind = Kind::choice,
       .choices = names_of<sim::OnFailure>,
       .meaning = "What happens to a step whose equations are not solved: \"split\" takes it again in halves (16 parts "
                  "at most), \"accept\" goes on with what there is, \"stop\" ends the run.",
       .binding = field<solver_of, &sim::Solver::on_failure>},
  };
}

}  // namespace app
