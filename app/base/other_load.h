// What other programs take of the machine.
#pragma once

#include <optional>

#include "app/base/stopwatch.h"

namespace app {

// From its making on. For the user's eye: nothing is decided by it.
class OtherLoad {
 public:
  OtherLoad();
  // Cores that other programs have kept busy on average; nothing where the system does not tell.
  std::optional<double> cores() const;

 private:
  Stopwatch watch_;
  std::optional<double> busy_;  // s, of all cores together since the machine started
  double own_;                  // s, of this program
};

// CPU seconds of this program, all threads together.
double own_cpu_seconds();

}  // namespace app
