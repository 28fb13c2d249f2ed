// session.toml, as a session goes on: every input with its step, on the disk at once.
#pragma once

#include <filesystem>
#include <string>

#include "app/base/output_file.h"
#include "app/options/options.h"
#include "app/session/input.h"
#include "sim/state.h"

namespace app {

class SessionLog {
 public:
  // Begins the file options.log anew, with what the options say of the scene. Throws WriteError; so do the others.
  // `dimension`: how many numbers a point has.
  SessionLog(const Options& options, int dimension);

  void write(const Event& event);
  // How the session ended: steps taken and the state they led to.
  void end(std::int64_t steps, const sim::State& state);

 private:
  OutputFile file_;
  int dimension_;
};

// An event as it stands in the file.
std::string event_text(const Event& event, int dimension);

}  // namespace app
