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
       .choices = linear_solver_names,
       .meaning = "Linear solver inside Newton's method.",
       .binding = field<solver_of, &sim::Solver::linear>},
      {.path = "solver.tolerance",
       .kind = Kind::number,
       .unit = "body sizes/s",
       .range = inside(0, 1),
       .meaning = "Newton stops when max |dx|/(g h) is below it; g is the integrator's share of the step.",
       .binding = field<solver_of, &sim::Solver::tolerance>},
      {.path = "solver.max_iterations",
       .kind = Kind::integer,
       .range = between(1, 100000),
       .meaning = "Newton iterations per stage; where they do not suffice, the step is reported as not converged.",
       .binding = field<solver_of, &sim::Solver::max_iterations>},
      {.path = "solver.lag_iterations",
       .kind = Kind::integer,
       .range = between(0, 100),
       .meaning =
           "The stiffness in beta damping and the pressure in friction are those of the step's start, which costs an "
           "order of accuracy in them; this many times they are evaluated anew at a stage's solution.",
       .binding = field<solver_of, &sim::Solver::lag_iterations>},
      {.path = "solver.definiteness",
       .kind = Kind::choice,
       .choices = definiteness_names,
       .meaning =
           "What is done to negative eigenvalues of an element's stiffness: set to zero, made positive, or kept.",
       .binding = field<solver_of, &sim::Solver::definiteness>},
      {.path = "solver.on_failure",
       .kind = Kind::choice,
       .choices = on_failure_names,
       .meaning = "A step whose equations are not solved: is taken again in halves (16 parts at most), is accepted as "
                  "it is, or stops the run.",
       .binding = field<solver_of, &sim::Solver::on_failure>},
  };
}

}  // namespace app
