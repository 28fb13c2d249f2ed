// What is thrown when a file cannot be read or written.
#pragma once

#include <stdexcept>

namespace app {

// The message starts with the place: "bear.msh:12: ..." (text) or "bear.msh: offset 480: ..." (bytes), and says what
// was wrong, the value that was found and what would be right.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace app
