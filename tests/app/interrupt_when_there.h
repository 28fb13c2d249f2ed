// Ctrl+C at a moment that a test can name.
#pragma once

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

namespace app {

// Sends SIGINT to this process as soon as the file is there.
inline std::thread interrupt_when_there(const std::filesystem::path& file) {
  return std::thread([file] {
    while (!std::filesystem::exists(file)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    kill(getpid(), SIGINT);
  });
}

}  // namespace app
