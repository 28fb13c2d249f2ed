// What a scene chooses between: an enum for each choice, and the name that a scene has for each of its values.
#pragma once

#include <array>
#include <string_view>

namespace sim {

// How the linear system of a Newton step is solved; `automatic` by size and by counts of iterations.
enum class LinearSolverKind { two_level, cholmod, pcg, pcg_assembled, automatic };

// What negative eigenvalues of a tangent are multiplied by: none 1, clamp 0 [Teran et al. 2005], abs -1 [Chen et al.
// 2024].
enum class Definiteness { none = 1, clamp = 0, abs = -1 };

// Whether Newton's method may leave what `Definiteness` says where that is slow or fails, and halve any step (guarded),
// or keeps to it, with whole steps where nothing is made definite (pure).
enum class NewtonKind { guarded, pure };

// What is done about a step whose equations are not solved.
enum class OnFailure { split, accept, stop };

enum class MassMatrix { lumped, consistent };

// What the vectors of a basis are: vibration modes, modes and what they change of each other, or what a run went
// through.
enum class BasisKind { modes, derivatives, snapshots };

template <class E>
struct Choice {
  E value;
  std::string_view name;
};

// Every value of E with its name, in the order in which they are listed.
template <class E>
inline constexpr std::array<Choice<E>, 0> choices;
template <>
inline constexpr auto choices<LinearSolverKind> =
    std::to_array<Choice<LinearSolverKind>>({{LinearSolverKind::automatic, "auto"},
                                             {LinearSolverKind::two_level, "two-level"},
                                             {LinearSolverKind::cholmod, "cholmod"},
                                             {LinearSolverKind::pcg, "pcg"},
                                             {LinearSolverKind::pcg_assembled, "pcg-assembled"}});
template <>
inline constexpr auto choices<Definiteness> = std::to_array<Choice<Definiteness>>({{Definiteness::clamp, "clamp"},
                                                                                   {Definiteness::abs, "abs"},
                                                                                   {Definiteness::none, "none"}});
template <>
inline constexpr auto choices<NewtonKind> = std::to_array<Choice<NewtonKind>>({{NewtonKind::guarded, "guarded"},
                                                                               {NewtonKind::pure, "pure"}});
template <>
inline constexpr auto choices<OnFailure> = std::to_array<Choice<OnFailure>>({{OnFailure::split, "split"},
                                                                             {OnFailure::accept, "accept"},
                                                                             {OnFailure::stop, "stop"}});
template <>
inline constexpr auto choices<MassMatrix> = std::to_array<Choice<MassMatrix>>({{MassMatrix::lumped, "lumped"},
                                                                               {MassMatrix::consistent, "consistent"}});
template <>
inline constexpr auto choices<BasisKind> = std::to_array<Choice<BasisKind>>({{BasisKind::derivatives, "derivatives"},
                                                                             {BasisKind::modes, "modes"},
                                                                             {BasisKind::snapshots, "snapshots"}});

template <class E>
constexpr std::string_view name_of(E value) {
  for (const Choice<E>& choice : choices<E>)
    if (choice.value == value) return choice.name;
  return {};
}

}  // namespace sim
