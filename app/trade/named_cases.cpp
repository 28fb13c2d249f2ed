#include "app/trade/named_cases.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "app/trade/case_file.h"
#include "app/trade/lists.h"
#include "app/trade/search.h"

namespace app {
namespace {

constexpr int most_steps = 64;  // a frame

std::vector<TradeCase> stored_cases(const std::filesystem::path& folder) {
  std::vector<TradeCase> all;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "cases", none)) {
    std::ifstream in(entry.path(), std::ios::binary);
    const auto run = decode_case(std::string{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
    if (run && run->path.frames() > 0) all.push_back(run->which);
  }
  return all;
}

// A scheme with any number of steps a frame, as the table calls it: "sdirk2 h=1/90".
std::optional<TradeCase> with_any_step(const Document& scene, const std::string& name) {
  for (const std::string& scheme : implicit_schemes(scene))
    for (int substeps = 1; substeps <= most_steps; ++substeps)
      if (TradeCase which = time_case(scene, scheme, substeps); which.label == name) return which;
  return std::nullopt;
}

// The one of this name, or whose name alone has it as a part.
class Choice {
 public:
  Choice(const std::vector<TradeCase>& all, const std::string& name) {
    for (const TradeCase& which : all) {
      if (which.label == name) exact_ = which;
      if (which.label.find(name) != std::string::npos &&
          std::ranges::find(parts_, which.label, &TradeCase::label) == parts_.end())
        parts_.push_back(which);
    }
  }

  const std::optional<TradeCase>& exact() const { return exact_; }
  const std::vector<TradeCase>& parts() const { return parts_; }

 private:
  std::optional<TradeCase> exact_;
  std::vector<TradeCase> parts_;
};

[[noreturn]] void refuse(const std::string& name, const std::string& why, const std::vector<TradeCase>& there) {
  std::vector<std::string> labels;
  for (const TradeCase& which : there) labels.push_back(which.label);
  std::ranges::sort(labels);
  const auto repeated = std::ranges::unique(labels);
  labels.erase(repeated.begin(), repeated.end());
  std::string text = "--show " + name + ": " + why;
  for (const std::string& label : labels) text += (&label == &labels.front() ? ": " : "; ") + label;
  throw std::runtime_error(text);
}

}  // namespace

std::vector<TradeCase> named_cases(const Comparison& comparison, const std::filesystem::path& folder) {
  const TradeOptions& options = comparison.options.trade;
  if (options.show_names.empty()) return {};
  const Document& scene = comparison.scene.document;
  const std::vector<TradeCase> stored = comparison.options.overwrite ? std::vector<TradeCase>() : stored_cases(folder);
  std::vector<TradeCase> there = stored, found;
  if (!options.collect)
    std::ranges::copy(independent_cases(scene, {4, comparison.scene.last_frame()}, options.keep_mesh),
                      std::back_inserter(there));
  for (const std::string& name : options.show_names) {
    const Choice of_stored(stored, name), of_all(there, name);
    const auto stepped = options.collect ? std::nullopt : with_any_step(scene, name);
    if (of_all.exact())
      found.push_back(*of_all.exact());
    else if (stepped)
      found.push_back(*stepped);
    else if (of_stored.parts().size() == 1)
      found.push_back(of_stored.parts().front());
    else if (of_all.parts().size() == 1)
      found.push_back(of_all.parts().front());
    else if (of_all.parts().empty())
      refuse(name, there.empty() ? "no run lies in " + folder.string() : "no run is called so; there are", there);
    else
      refuse(name, "it is a part of the names of several", of_all.parts());
  }
  return found;
}

}  // namespace app
