#include "app/base/interrupt.h"

#include <atomic>

namespace app {
namespace {

// The one global of the program: a signal handler has no other way to tell anyone.
std::atomic<bool> requested_flag = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void request_interrupt(int) {
  requested_flag.store(true);
}

void handle(int signal, void (*handler)(int), int flags, struct sigaction& before) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, &before);
}

}  // namespace

Interrupt::Interrupt() {
  requested_flag.store(false);
  // SA_RESETHAND: the second signal finds the default action; SA_RESTART: a write in progress goes on.
  const int once = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  handle(SIGINT, request_interrupt, once, int_before_);
  handle(SIGTERM, request_interrupt, once, term_before_);
  handle(SIGHUP, request_interrupt, once, hangup_before_);
  if (hangup_before_.sa_handler == SIG_IGN) sigaction(SIGHUP, &hangup_before_, nullptr);
  handle(SIGXFSZ, SIG_IGN, 0, size_before_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &int_before_, nullptr);
  sigaction(SIGTERM, &term_before_, nullptr);
  sigaction(SIGHUP, &hangup_before_, nullptr);
  sigaction(SIGXFSZ, &size_before_, nullptr);
}

bool Interrupt::requested() const {
  return requested_flag.load();
}

}  // namespace app
