// Scenes as text for tests, and a folder to load them from.
#pragma once

#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "tests/app/temporary_folder.h"

namespace app {

// Every part of a scene, in 3D.
inline constexpr const char* beam_scene = R"(title = "beam"
[time]
seconds = 1.5
fps = 50
step = 0.004
[[body]]
name = "beam"
mesh = { box = [4, 1, 1], cells = [4, 2, 2], grading = [1.6, 1, 1] }
material = { young = 2e5, poisson = 0.3 }
damping.beta = 0.01
[[body.pin]]
box = [[-1e-6, -1, -1], [1e-6, 2, 2]]
release = 1.5
[[body.pin]]
sphere = [[4, 0, 0], 0.1]
axes = "xy"
motion = { keyframes = [[0.0, {}], [1.0, { translate = [0, 1, 0], rotate = { axis = [0, 2, 0], degrees = 90, centre = [1, 0, 0] } }]] }
[[body.traction]]
group = "right"
value = [0, 5, 0]
ramp = 0.5
[[obstacle]]
plane = { point = [0, -1, 0], normal = [0, 3, 4] }
friction = 0.3
[[obstacle]]
sphere = [[9, 0, 0], 2]
[[spring]]
body = "beam"
at = [2, 0.5, 0.5]
target = [2, 2, 0.5]
stiffness = 100
[[probe]]
name = "tip"
body = "beam"
at = [4, 0.5, 0.5]
[camera]
eye = [2, 0.5, 7]
[look]
colour = "stress"
range = [0, 1e5]
)";

class SceneFile : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) const {
    write_all(folder_ / name, text);
    return folder_ / name;
  }
  Document load(const std::string& text, const std::vector<Override>& overrides = {}) const {
    return load_scene(file("scene.toml", text), {}, overrides);
  }
  // The message without the folder.
  std::string error(const std::string& text, const std::vector<Override>& overrides = {}) const {
    std::string message = error_of([&] { load(text, overrides); });
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
      message.erase(at, folder.size());
    }
    return message;
  }
  static Override set(const std::string& key, const std::string& value) {
    return {key, value, "--set " + key + "=" + value};
  }

  TemporaryFolder folder_;
};

// One body with more keys, from line 3 on.
inline std::string body(const std::string& more) {
  return "[[body]]\nmesh = { box = [1, 1, 1], cells = [1, 1, 1] }\n" + more;
}

}  // namespace app
