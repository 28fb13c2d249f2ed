// The names that a caption may have in braces, each for a live value of the run.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

// t [s], frame, steps taken, step = h [s], energy = kinetic + elastic + potential [J], iterations of Newton in the last
// step, min_J = the smallest det F after it, nodes, elements.
enum class CaptionValue {
  t,
  frame,
  steps,
  step,
  energy,
  kinetic,
  elastic,
  potential,
  iterations,
  min_J,
  nodes,
  elements
};

std::optional<CaptionValue> find_caption_value(std::string_view name);
std::vector<std::string> known_caption_names();

// The {names} in a text, in their order.
std::vector<std::string> caption_names(const std::string& text);

// Calls plain(text) and name(text) for the parts of a text, in their order; a brace that is not closed is plain.
void for_each_caption_part(std::string_view text, const std::function<void(std::string_view)>& plain,
                           const std::function<void(std::string_view)>& name);

}  // namespace app
