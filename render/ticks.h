// Round numbers for axes and legends.
#pragma once

#include <string>
#include <vector>

namespace render {

// The largest of 1, 2, 5 times a power of ten that is <= length (> 0).
double round_length(double length);

// Multiples of a round step within [low, high], about `wanted` of them, never more than 2.5 times as many; the one
// number when low = high. Both ends must be finite.
std::vector<double> ticks(double low, double high, int wanted);

// A round number to count them from, where they differ in their last digits only, as map coordinates do; else 0.
double tick_offset(const std::vector<double>& values);

// The numbers as short as they can be told apart: equal decimals, or an exponent where they are very large or small.
std::vector<std::string> tick_labels(const std::vector<double>& values);

// "10⁻³"
std::string power_of_ten(int exponent);

}  // namespace render
