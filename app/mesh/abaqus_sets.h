// Sets of an Abaqus input file: of nodes, of elements, of faces of elements.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/mesh/abaqus_cards.h"

namespace app {

// What a line of a set names: numbers in steps, or another set; and for surfaces the face of these elements.
struct AbaqusEntry {
  std::int64_t first = 0, last = 0, step = 1;
  std::string set;        // in capitals; empty: numbers
  int face = 0;           // 1 for S1, ...; 0: none
  std::size_t place = 0;  // in the file
};

struct AbaqusSet {
  std::string name;  // as it was written first
  bool internal = false;
  std::vector<AbaqusEntry> entries;
};

// By the name in capitals: Abaqus does not tell letters of different size apart.
using AbaqusSets = std::map<std::string, AbaqusSet>;

// The set of that name, which is made where there is none.
AbaqusSet& named_set(AbaqusSets& sets, const std::string& name);

// The data below *NSET, *ELSET and *SURFACE. Throw FileError.
void read_abaqus_set(Cursor& in, const AbaqusCard& card, AbaqusSet& set);
void read_abaqus_surface(Cursor& in, AbaqusSet& set);

// Indices of the numbered things that a set names, ascending; numbers: index of each thing by its number. Fails at
// names of sets that are not there or contain themselves, not at numbers that nothing has: Abaqus lets them pass.
std::vector<std::size_t> members(Cursor& in, const AbaqusSets& sets, const AbaqusEntry& entry,
                                 const std::map<std::int64_t, std::size_t>& numbers);

}  // namespace app
