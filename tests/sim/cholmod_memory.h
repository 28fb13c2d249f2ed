// Where CHOLMOD takes its memory from, and how SuiteSparse is told: by a struct up to version 5, by functions since.
#pragma once

#include <SuiteSparse_config.h>

#include <cstddef>

namespace sim::test {

inline void give_memory_to_cholmod(void* (*malloc)(std::size_t), void* (*calloc)(std::size_t, std::size_t),
                                   void* (*realloc)(void*, std::size_t)) {
#if SUITESPARSE_MAIN_VERSION < 6
  SuiteSparse_config.malloc_func = malloc;
  SuiteSparse_config.calloc_func = calloc;
  SuiteSparse_config.realloc_func = realloc;
#else
  SuiteSparse_config_malloc_func_set(malloc);
  SuiteSparse_config_calloc_func_set(calloc);
  SuiteSparse_config_realloc_func_set(realloc);
#endif
}

}  // namespace sim::test
