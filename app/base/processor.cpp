// Compiled for the first x86-64, whatever the rest is compiled for: this runs where the rest cannot. It uses nothing of
// the C++ library, whose inline functions the linker may take from a file that was compiled for more.
#include "app/base/processor.h"

#include <unistd.h>

#include <cstring>

#include "app/base/exit_code.h"

namespace app {

#ifdef __x86_64__

namespace {

bool has_instruction(const char* name) {
  __builtin_cpu_init();
  // The compiler wants each name as a literal.
#define RITZ_HAS(literal) \
  if (std::strcmp(name, literal) == 0) return __builtin_cpu_supports(literal) != 0
  RITZ_HAS("sse4.2");
  RITZ_HAS("sse4a");
  RITZ_HAS("popcnt");
  RITZ_HAS("lzcnt");
  RITZ_HAS("movbe");
  RITZ_HAS("bmi");
  RITZ_HAS("bmi2");
  RITZ_HAS("f16c");
  RITZ_HAS("avx");
  RITZ_HAS("avx2");
  RITZ_HAS("fma");
  RITZ_HAS("avx512f");
  RITZ_HAS("avx512cd");
  RITZ_HAS("avx512dq");
  RITZ_HAS("avx512bw");
  RITZ_HAS("avx512vl");
  RITZ_HAS("avx512ifma");
  RITZ_HAS("avx512vbmi");
  RITZ_HAS("avx512vbmi2");
  RITZ_HAS("avx512vnni");
  RITZ_HAS("avx512bitalg");
  RITZ_HAS("avx512vpopcntdq");
  RITZ_HAS("gfni");
  RITZ_HAS("vaes");
  RITZ_HAS("vpclmulqdq");
#undef RITZ_HAS
  return false;
}

void say(const char* words) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words, std::strlen(words));
}

// Before every other initialisation of the program, which may use such instructions already.
__attribute__((constructor(101))) void check_processor() {
  const char* const missing = first_missing_instruction(needed_instructions);
  if (missing == nullptr) return;
  say("ritz: this processor does not have the instructions \"");
  say(missing);
  say("\" that this program was built with; build it on this machine, or with -DRITZ_PORTABLE=ON where it has avx2\n");
  _exit(exit_bad_input);
}

}  // namespace

const char* first_missing_instruction(const char* const* names) {
  while (*names != nullptr && has_instruction(*names)) ++names;
  return *names;
}

#else

const char* first_missing_instruction(const char* const*) {
  return nullptr;
}

#endif

}  // namespace app
