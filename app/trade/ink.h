// How the diagram of a trade tells its lines apart: each has a colour, a mark and dashes of its own, which are the same
// in every diagram.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace app {

// Lines and marks are bright with dark edges. The edges and the letters beside them are seen where a projector washes
// them out: mixed with 40 % of white they have a contrast of 4.5 with white. What is within the edges tells lines
// apart. Where both are equal there is no edge.
struct Ink {
  const char* dark;
  const char* bright;
  int mark;             // as gnuplot counts them, the closed ones; those from 1 to 3 are crosses
  bool hollow = false;  // with a white middle
  int dashes = 1;       // 1: none; 2 for schemes of first order, 3 for explicit ones
};

inline constexpr const char* black = "#000000";
inline constexpr const char* blue = "#0000c8";
inline constexpr const char* red = "#640000";

struct SchemeInk {
  std::string_view integrator;
  Ink ink;
};

// Filled marks are implicit and of second order, hollow ones are of first order or explicit.
inline constexpr SchemeInk scheme_inks[] = {
    {"backward-euler", {"#600000", "#ff3030", 5, true, 2}},
    {"linearly-implicit", {"#4c0040", "#ff70d8", 9, true, 2}},
    {"bdf2", {"#002300", "#28c828", 13}},
    {"trapezoidal", {"#280090", "#a050ff", 11}},
    {"implicit-midpoint", {"#001c48", "#20e0f0", 3}},
    {"sdirk2", {"#1a1a00", "#ffd800", 9}},
    {"tr-bdf2", {"#0000c8", "#3878ff", 7}},
    {"symplectic-euler", {"#000000", "#f0f0f0", 13, true, 3}},
    {"central-difference", {"#2a1400", "#a87040", 11, true, 3}},
};

// What has no colour of its own.
inline constexpr Ink mesh_ink = {black, black, 1}, setting_ink = {black, black, 2}, scene_ink = {black, black, 5},
                     advice_ink = {red, red, 6}, check_ink = {red, red, 2};

// Of an integrator.
Ink ink_of(std::string_view integrator);

// Every colour that letters and edges are drawn with.
std::vector<std::string> dark_colours();

}  // namespace app
