// Other programs: started, and waited for.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace app {

// Starts a program with `input` as its standard input (-1: ours) and nothing as its output, in a process group of its
// own, so that Ctrl+C does not reach it. Returns an errno value.
int start_process(std::vector<std::string> words, int input, pid_t& process);

// Whether a program of this name is in a folder of PATH.
bool is_installed(const std::string& program);

// What waitpid says of its end.
int wait_for_process(pid_t process);

}  // namespace app
