// Steps a system until its bodies are at rest, or as often as asked for, and says whether they have returned to their
// rest shapes.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/system.h"

namespace sim {

// Largest distance of a node from where it would be in the shape x_other, after the rotation and translation that fit
// best (weights: masses), over the sizes of the bodies. Parts of a body that are not connected move each by itself.
// [Kabsch 1976; a mirror image is another shape]
double shape_distance(const System& system, const Eigen::VectorXd& x, const Eigen::VectorXd& x_other);

// Interior edges (in the plane: nodes) around which the elements are not wound exactly once. With none of them and no
// inverted element the body is nowhere folded through itself. 0 for membranes.
int wound_places(const System& system, const Eigen::VectorXd& x);

enum class Verdict {
  recovered,          // at rest, no further than 1e-4 of the size from the rest shape
  at_rest_loaded,     // at rest under the scene's loads
  other_equilibrium,  // at rest elsewhere, perhaps with inverted elements
  moving,             // at the end, by physics: its steps are solved, it had no time to come to rest
  iterating,          // at the end, or after 50 steps in a row that were not solved: the last one was not
  stopped,            // a step could not be taken
};

struct Recovery {
  Verdict verdict = Verdict::moving;
  std::string failure;     // where stopped: step, time, element, reason
  std::string reason;      // of the first step that did not converge
  double distance = 0;     // from the rest shape at the end [body sizes]
  double min_J = 0;        // smallest after any step
  int inverted = 0;        // elements at the end
  int wound = 0;           // wound_places at the end
  std::int64_t steps = 0;  // taken; fewer than asked for where it came to rest before
  int not_converged = 0;   // steps
  std::int64_t splits = 0, newton = 0, linear = 0;
  // Largest rise of kinetic, elastic and potential energy above the start's, over the largest kinetic and elastic
  // energy; told where asked for.
  std::optional<double> gain;

  // The same body, gone on with.
  void then(const Recovery& later);
};

// What recover looks at besides the shape.
struct RecoveryOptions {
  bool loaded = false;  // the scene has loads, so that the rest shape is not what it should come to
  bool energy = false;  // nothing but forces of a potential acts: the gain of energy is looked for
};

// Moves the state by `steps` steps, or fewer when the shape does not change any more, 50 in a row are not solved, or
// the energy that is looked at has been a hundred times the start's for 50: that is no motion any more. Ends early,
// with what there is, when `interrupted` says so.
Recovery recover(const System& system, State& state, std::int64_t steps, const RecoveryOptions& options,
                 const std::function<bool()>& interrupted);

}  // namespace sim
