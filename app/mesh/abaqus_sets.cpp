#include "app/mesh/abaqus_sets.h"

#include <algorithm>
#include <set>

#include "app/base/text.h"

namespace app {
namespace {

// The sets on the way to an entry, and all that were met: a second visit would find nothing new.
struct Path {
  std::vector<std::string> within;
  std::set<std::string> met;
};

void gather(Cursor& in, const AbaqusSets& sets, const AbaqusEntry& entry,
            const std::map<std::int64_t, std::size_t>& numbers, Path& path, std::vector<std::size_t>& result) {
  if (entry.set.empty()) {
    for (auto at = numbers.lower_bound(entry.first); at != numbers.end() && at->first <= entry.last; ++at) {
      if ((static_cast<std::uint64_t>(at->first) - static_cast<std::uint64_t>(entry.first)) %
              static_cast<std::uint64_t>(entry.step) ==
          0)
        result.push_back(at->second);
    }
    return;
  }
  const auto found = sets.find(entry.set);
  const bool circle = std::ranges::find(path.within, entry.set) != path.within.end();
  if (found == sets.end() || circle) {
    in.go_to(entry.place);
    const std::string name = quote(in.word("the name of a set"));
    in.fail(circle ? "the set " + name + " contains itself" : "there is no set " + name);
  }
  if (!path.met.insert(entry.set).second) return;
  path.within.push_back(entry.set);
  for (const AbaqusEntry& inner : found->second.entries) gather(in, sets, inner, numbers, path, result);
  path.within.pop_back();
}

}  // namespace

AbaqusSet& named_set(AbaqusSets& sets, const std::string& name) {
  AbaqusSet& set = sets[in_capitals(name)];
  if (set.name.empty()) set.name = name;
  return set;
}

void read_abaqus_set(Cursor& in, const AbaqusCard& card, AbaqusSet& set) {
  set.internal = set.internal || card.options.contains("INTERNAL");
  const bool generate = card.options.contains("GENERATE");
  while (!abaqus_data_finished(in)) {
    AbaqusEntry entry;
    entry.place = in.position();
    const std::string_view word = in.word("a member of a set");
    if (word.empty()) in.fail("there is nothing between two commas");
    if (!parse(word, entry.first)) entry.set = in_capitals(word);
    entry.last = entry.first;
    if (generate) {
      entry.last = in.whole("the last number");
      if (!in.line_finished()) entry.step = in.integer("the step", 1, 1 << 30);
    }
    set.entries.push_back(entry);
  }
}

void read_abaqus_surface(Cursor& in, AbaqusSet& set) {
  while (!abaqus_data_finished(in)) {
    AbaqusEntry entry;
    entry.place = in.position();
    const std::string_view word = in.word("an element or a set of elements");
    if (!parse(word, entry.first)) entry.set = in_capitals(word);
    entry.last = entry.first;
    if (!in.line_finished()) {
      const std::string face = in_capitals(in.word("a face"));
      std::int64_t number = 0;
      if (face.size() == 2 && face[0] == 'S' && parse(std::string_view(face).substr(1), number) && number > 0)
        entry.face = static_cast<int>(number);
    }
    in.rest_of_line();
    set.entries.push_back(entry);
  }
}

std::vector<std::size_t> members(Cursor& in, const AbaqusSets& sets, const AbaqusEntry& entry,
                                 const std::map<std::int64_t, std::size_t>& numbers) {
  std::vector<std::size_t> result;
  Path path;
  gather(in, sets, entry, numbers, path, result);
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace app
