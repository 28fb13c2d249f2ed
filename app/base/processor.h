// Which instructions of the processor this program uses, and what is said where one is missing.
#pragma once

namespace app {

// Names of the sets of instructions beyond the first x86-64 that the compiler was allowed to use, ended by a null.
// Plain data, because it is read before anything else of the program runs.
extern const char* const needed_instructions[];

// The first of these names that this processor does not have; null where it has them all.
const char* first_missing_instruction(const char* const* names);

}  // namespace app
