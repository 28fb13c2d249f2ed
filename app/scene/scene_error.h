// Errors of a scene, with the place of what was wrong.
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include "sim/mesh/input_error.h"
#include "sim/scene.h"

namespace app {

// A scene that cannot be used. what() says where, which key, its value and what would be right:
// "scene.toml:12: body.0.material.poisson = 0.6: must be in (-1, 0.5)".
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Where a key was given, and its value as it was written (empty for tables and lists).
struct Place {
  std::string where;  // "scene.toml:12", "--set time.fps=30"
  std::string text;
  int line = 0, column = 0;  // in a file, from 1; else 0
};
using Places = std::map<std::string, Place, std::less<>>;  // by path: "body.0.material.young"; "" is the whole scene

// What is wrong with one key: the message as of SceneError.
struct Mistake {
  std::string path;  // of the key that was refused, or that was meant by one that is not known
  Place place;
  std::string message;
};

// What was refused, with the place of the key at fault (or of the nearest table around it).
Mistake located(const sim::InputError& error, const Places& places);

}  // namespace app
