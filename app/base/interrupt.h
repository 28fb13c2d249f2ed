// Ctrl+C, SIGTERM and a closed terminal (SIGHUP) as a question that the run asks after every step.
#pragma once

#include <csignal>

namespace app {

// While it lives, SIGINT, SIGTERM and SIGHUP set a flag instead of ending the process; a second one of the same kind
// ends it as usual. A SIGHUP that is ignored (nohup) stays so. A full file-size quota (SIGXFSZ) becomes a write error.
// At most one object at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested() const;

 private:
  struct sigaction int_before_ {};
  struct sigaction term_before_ {};
  struct sigaction hangup_before_ {};
  struct sigaction size_before_ {};
};

}  // namespace app
