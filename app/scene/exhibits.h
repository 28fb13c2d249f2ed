// The exhibits that a page of a lecture can have: one table. A new one is its file in app/exhibit and a line here.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "app/scene/exhibit_spec.h"
#include "sim/system.h"

namespace app {

class Exhibit;  // app/exhibit/exhibit.h

// All of it outlives the exhibit, but for `spec`.
struct ExhibitInput {
  const sim::Scene& scene;
  const sim::System& system;
  const ExhibitSpec& spec;
  const std::filesystem::path& folder;  // that files of the exhibit are told from
};

struct ExhibitKind {
  std::string_view name, what;
  std::vector<std::string_view> keys;  // of [[exhibit]], those that it has beside kind
  // Throws sim::InputError with a key below the exhibit's own ("element") where the scene has not what it shows.
  std::unique_ptr<Exhibit> (*make)(const ExhibitInput&);
};

std::span<const ExhibitKind> exhibit_kinds();
const ExhibitKind* find_exhibit_kind(std::string_view name);
// Whether exhibits of this kind have this key of [[exhibit]].
bool exhibit_has(std::string_view kind, std::string_view key);

}  // namespace app
