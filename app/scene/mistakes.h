// What is wrong with a scene, collected: all of it is told at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/scene/scene_error.h"

namespace app {

class Mistakes {
 public:
  // Those that were found while reading; a later mistake is placed by `places`, which must outlive this.
  Mistakes(std::vector<Mistake> found, const Places& places) : found_(std::move(found)), places_(places) {}

  // The key of this path is refused: why, as "must be > 0".
  void refuse(const std::string& path, const std::string& why);
  // Does something, and keeps what it refuses by sim::InputError.
  template <class Work>
  void collect(const Work& work) {
    try {
      work();
    } catch (const sim::InputError& error) {
      refuse(error.key, error.what());
    }
  }

  // From here on, what is wrong in a part of the scene that is refused already ("body.0", "camera") is no news: it may
  // follow from that.
  void next_stage() { earlier_ = found_.size(); }
  // Whether something is wrong in the part of the scene that holds this path.
  bool in_part_of(std::string_view path) const;

  bool empty() const { return found_.empty(); }
  // All of them, a line each: those of the scene file, then of other files, then of overrides, each in their order.
  SceneError error(const std::string& scene) const;

 private:
  std::vector<Mistake> found_;
  const Places& places_;
  std::size_t earlier_ = 0;  // so many were found before this stage
};

}  // namespace app
