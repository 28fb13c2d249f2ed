// Implicit schemes as rows of one table over one stage solver. [mathematics.md 7]
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace sim {

// What a stage may start from: the state now, the one before, the first stage of this step.
enum Source { now, before, first_stage, source_count };

// A stage solves  x_s = x* + g h v_s,  M v_s = M v* + g h f(x_s)  with
//   x* = sum_k c_k x_k + h sum_k d_k v_k,   M v* = sum_k c_k M v_k + h sum_k d_k f_k   over the sources k
// at the time t_n + end h.
struct Stage {
  std::array<double, source_count> c, d;
  double g;
  double end;

  // How often barriers and their friction count at its end. Their force comes and goes within a step: a share of it
  // that is taken from the step's start, or an impulse of the first stage that is drawn out longer, does work that no
  // one has paid for, and bodies gain energy where they hit something. So both are left out, and this is so large that
  // a constant force still gives what it should by the end: end = g barriers() - c[before] + d[first_stage]. [after
  // Kane et al. 1999]
  constexpr double barriers() const { return (end + c[before] - d[first_stage]) / g; }
};

// How the velocity gets its forces: from implicit stages, in one kick at the step's start, or in two half kicks at both
// of its ends.
enum class Kick { none, whole, halves };

struct Scheme {
  std::string_view name;
  int order;
  std::span<const Stage> stages = {};  // of an implicit scheme
  Kick kick = Kick::none;              // of an explicit one
  std::string_view first_step = {};    // a two-step scheme: the scheme that makes its first step
  bool extrapolate = false;            // x_{n+1} = 2 x_s - x_n
  bool one_iteration = false;          // exactly one Newton step
  bool is_static = false;              // minimise U alone

  bool is_explicit() const { return kick != Kick::none; }
  // Its steps end where an iteration has seen that nothing is in the way.
  bool heeds_barriers() const { return !is_explicit() && !extrapolate && !one_iteration; }
};

// nullptr when there is no scheme of that name.
const Scheme* find_scheme(std::string_view name);
std::span<const Scheme> schemes();

}  // namespace sim
