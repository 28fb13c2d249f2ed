#include "sim/time/scheme.h"

namespace sim {

namespace {

constexpr double sqrt2 = 1.41421356237309504880;
constexpr double gamma_sdirk = 1 - 1 / sqrt2;  // [Alexander 1977]
constexpr double gamma_tr = 2 - sqrt2;         // tr-bdf2: where the trapezoidal part ends [Bank et al. 1985]
constexpr double w_tr = 1 / (gamma_tr * (2 - gamma_tr));

//                                              c: now before first      d: now before first      g            end
constexpr Stage backward_euler[] = {{{1, 0, 0}, {0, 0, 0}, 1, 1}};
constexpr Stage bdf2[] = {{{4.0 / 3, -1.0 / 3, 0}, {0, 0, 0}, 2.0 / 3, 1}};
constexpr Stage trapezoidal[] = {{{1, 0, 0}, {0.5, 0, 0}, 0.5, 1}};
constexpr Stage midpoint[] = {{{1, 0, 0}, {0, 0, 0}, 0.5, 0.5}};
constexpr Stage sdirk2[] = {{{1, 0, 0}, {0, 0, 0}, gamma_sdirk, gamma_sdirk},
                            {{1, 0, 0}, {0, 0, 1 - gamma_sdirk}, gamma_sdirk, 1}};
constexpr Stage tr_bdf2[] = {{{1, 0, 0}, {gamma_tr / 2, 0, 0}, gamma_tr / 2, gamma_tr},
                             {{1 - w_tr, 0, w_tr}, {0, 0, 0}, (1 - gamma_tr) / (2 - gamma_tr), 1}};

constexpr Scheme table[] = {
    {.name = "symplectic-euler", .order = 1, .kick = Kick::whole},
    {.name = "central-difference", .order = 2, .kick = Kick::halves},
    {.name = "backward-euler", .order = 1, .stages = backward_euler},
    {.name = "linearly-implicit", .order = 1, .stages = backward_euler, .one_iteration = true},
    {.name = "bdf2", .order = 2, .stages = bdf2, .first_step = "sdirk2"},
    {.name = "trapezoidal", .order = 2, .stages = trapezoidal},
    {.name = "implicit-midpoint", .order = 2, .stages = midpoint, .extrapolate = true},
    {.name = "sdirk2", .order = 2, .stages = sdirk2},
    {.name = "tr-bdf2", .order = 2, .stages = tr_bdf2},
    {.name = "static", .order = 0, .stages = backward_euler, .is_static = true},
};

}  // namespace

std::span<const Scheme> schemes() {
  return table;
}

const Scheme* find_scheme(std::string_view name) {
  for (const Scheme& scheme : table)
    if (scheme.name == name) return &scheme;
  return nullptr;
}

}  // namespace sim
