// What a user does to a session: plain data, each applied between two steps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "sim/scene.h"

namespace app {

// A key of the scene gets a value. One that cannot change while a body moves (its mesh, say) waits for the restart.
struct SetKey {
  std::string key;    // "body.0.material.young"
  std::string value;  // TOML
};

// The camera; what is not given stays as it is.
struct MoveCamera {
  std::optional<sim::Vec3> eye;     // m, 3D
  std::optional<sim::Vec3> target;  // m
  std::optional<double> height;     // m, 2D
};

// A spring takes hold of a body, pulls somewhere else, lets go.
struct Pull {
  std::string body;
  sim::Vec3 at, target;  // m: material point, place in space
};
struct PullTo {
  sim::Vec3 target;  // m
};
struct Release {};

struct StepBack {};  // the state before the last step, while the history holds it
struct Reset {};     // the initial state; values stay as they were set
struct Restart {};   // the initial state, with the values that waited for it

using Input = std::variant<SetKey, MoveCamera, Pull, PullTo, Release, StepBack, Reset, Restart>;

// An input of a session, and how many steps the session had taken before it (steps back and resets do not count).
struct Event {
  std::int64_t step = 0;
  Input input;
};

}  // namespace app
