// What a page of a lecture adds to a scene: reads the system and a state, computes nothing by itself that sim can, and
// lays diagrams and numbers on the page's sheet.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/exhibit/trace.h"
#include "app/scene/document.h"
#include "app/scene/exhibits.h"
#include "render/sheet.h"
#include "sim/state.h"

namespace app {

// A ring on the page that can be dragged: it sets a key of the exhibit.
struct Grip {
  std::size_t diagram = 0;  // of the exhibit's own
  render::Spot at{};
  std::string key = {};                                        // "nodes"
  std::function<std::string(const render::Spot&)> value = {};  // TOML, for the ring at a spot
};

// The ring of number k of the key "values": the others stay.
Grip number_grip(std::size_t diagram, const render::Spot& at, std::vector<double> values, std::size_t k,
                 std::function<double(const render::Spot&)> number);

class Exhibit {
 public:
  virtual ~Exhibit() = default;
  // The state of every frame, in their order; one that is not later than others replaces them.
  virtual void note(const sim::State&) {}
  // What it keeps of the frames for its curves; none where it draws none over time.
  virtual Trace* trace() { return nullptr; }
  virtual void show(const sim::State& state, render::Sheet& sheet) const = 0;
  // Rings of what `show` draws of this state.
  virtual std::vector<Grip> grips(const sim::State&) const { return {}; }
};

// The exhibits of a document, and what they were made from.
struct Exhibits {
  std::shared_ptr<const sim::System> system = nullptr;
  std::vector<ExhibitSpec> specs = {};
  std::vector<std::unique_ptr<Exhibit>> all = {};

  bool are_of(const Document& document, const std::shared_ptr<const sim::System>& its) const {
    return system == its && specs == document.exhibits;
  }
};

// Throws SceneError where one has not what it shows.
Exhibits make_exhibits(const Document& document, std::shared_ptr<const sim::System> system);

}  // namespace app
