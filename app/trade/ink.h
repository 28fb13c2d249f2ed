// How the diagram of a trade tells its lines apart: by dark colours, by the shape of their points, by dashes.
#pragma once

#include <string>
#include <vector>

namespace app {

// Every colour that text, lines and points are drawn with: "#rrggbb". Each has a contrast of 4.5 with white even where
// a projector washes it out: mixed with 40 % of white.
std::vector<std::string> inks();

// As gnuplot says it.
struct Ink {
  std::string colour;
  int point = 7;
  int dashes = 1;  // 1: none; 2 for schemes of first order, 3 for explicit ones
};

// Of an integrator, the same in every diagram.
Ink ink_of(const std::string& integrator);

inline constexpr const char* black = "#000000";
inline constexpr const char* blue = "#0000c8";
inline constexpr const char* red = "#640000";
inline constexpr const char* purple = "#32008c";
inline constexpr const char* green = "#002300";

}  // namespace app
