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
      {"solver", Kind::table, {}, "How the equations of an implicit step are solved."},
      {"solver.linear", Form(Kind::choice).of(names_of<sim::LinearSolverKind>), field<solver_of, &sim::Solver::linear>,
       "Linear solver inside Newton's method: \"two-level\" iterates on the matrix and on a coarse one, \"cholmod\" "
       "factorises the matrix, \"pcg\" iterates and forms none, \"pcg-assembled\" iterates on it alone, \"auto\" "
       "chooses by size and by counts of iterations."},
      {"solver.tolerance", Form(Kind::number, "body sizes/s", inside(0, 1)), field<solver_of, &sim::Solver::tolerance>,
       "Newton's method stops when max |dx|/(g h) is below it; dx is the last change of the positions, h the step and "
       "g the integrator's share of it."},
      {"solver.max_iterations", Form(Kind::integer, "", between(1, 100000)),
       field<solver_of, &sim::Solver::max_iterations>,
       "The most Newton iterations that a stage of a step may take. Where they do not suffice although each gets on, "
       "the step is accepted unsolved, and so slow that it has no more energy than when it began. A step that is "
       "halved "
       "takes no more than twice as many in all its parts, and 20 for each part that is left then."},
      {"solver.lag_iterations", Form(Kind::integer, "", between(0, 100)),
       field<solver_of, &sim::Solver::lag_iterations>,
       "Beta damping takes its stiffness, friction its normal forces, and pressure what acts at a free rim from the "
       "beginning of the step, which costs them an order of accuracy. This many times a stage is solved again with "
       "these taken from its own solution."},
      {"solver.definiteness", Form(Kind::choice).of(names_of<sim::Definiteness>),
       field<solver_of, &sim::Solver::definiteness>,
       "What is done to negative eigenvalues of an element's stiffness: \"clamp\" sets them to zero, \"abs\" makes "
       "them positive, \"none\" keeps them."},
      {"solver.newton", Form(Kind::choice).of(names_of<sim::NewtonKind>), field<solver_of, &sim::Solver::newton>,
       "\"guarded\" takes the exact matrix where the one of solver.definiteness is slow, another where it fails, and "
       "halves steps that do not lower the energy; \"pure\" keeps to solver.definiteness, and with \"none\" takes "
       "whole "
       "steps wherever they lead: to a saddle or a maximum as well. Its linear systems are solved by LU."},
      {"solver.on_failure", Form(Kind::choice).of(names_of<sim::OnFailure>), field<solver_of, &sim::Solver::on_failure>,
       "What happens to a step whose equations are not solved: \"split\" takes it again in halves (16 parts at most) "
       "where its iterations no longer get on, \"accept\" goes on with what there is, \"stop\" ends the run."},
  };
}

}  // namespace app
