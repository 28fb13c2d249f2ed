// The lines of an Abaqus input file: keywords with their options, and the data below each.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "app/mesh/cursor.h"

namespace app {

// "*ELEMENT, TYPE=C3D4, ELSET=all": keyword and names of options in capitals, values as they are, without quotes.
struct AbaqusCard {
  std::string keyword;
  std::map<std::string, std::string> options;

  // Empty when the card does not have it.
  std::string option(const std::string& name) const;
};

// Skips comments (**) and blank lines. True when a card follows, or the end of the file: no data.
bool abaqus_data_finished(Cursor& in);

// The next card, which follows; it goes on where its line ends with a comma.
AbaqusCard read_abaqus_card(Cursor& in);

}  // namespace app
