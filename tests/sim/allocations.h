// Counts heap allocations of the calling program, by standing in front of malloc. CHOLMOD's own go round it.
#pragma once

namespace sim::test {

// True where counting works: not under AddressSanitizer, which has a malloc of its own.
bool can_count_allocations();
void start_counting();
long stop_counting();

}  // namespace sim::test
