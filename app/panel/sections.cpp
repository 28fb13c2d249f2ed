#include "app/panel/sections.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "app/scene/key_positions.h"

namespace app {
namespace {

// Groups that are open at first, and come first.
constexpr std::array<std::string_view, 3> first_sections = {"material", "damping", ""};

bool comes_first(std::string_view group) {
  return std::ranges::find(first_sections, group) != first_sections.end();
}

// The first name of a path, with its number: "body.0" of "body.0.material.young".
std::string section_of(const std::string& path) {
  std::size_t dot = path.find('.');
  if (dot != std::string::npos && std::isdigit(static_cast<unsigned char>(path[dot + 1])) != 0) {
    dot = path.find('.', dot + 1);
  }
  return path.substr(0, dot);
}

std::string title_of(const std::string& section, const Document& document) {
  const std::string body = "body.";
  if (!section.starts_with(body)) return section;
  return "body: " + document.scene.bodies[static_cast<std::size_t>(std::stoi(section.substr(body.size())))].name;
}

template <class Part>
Part& part_named(std::vector<Part>& parts, const std::string& name, std::string Part::*member) {
  const auto found = std::ranges::find(parts, name, member);
  if (found != parts.end()) return *found;
  Part part;
  part.*member = name;
  parts.push_back(std::move(part));
  return parts.back();
}

void add(std::vector<Section>& sections, const Document& document, Entry entry) {
  const std::string place = section_of(entry.path);
  Section& section = part_named(sections, place, &Section::path);
  if (section.title.empty()) {
    section.title = title_of(place, document);
    section.open = place == "time" || place == "solver" || place == "body.0";
  }
  const std::string rest = place == entry.path ? std::string() : entry.path.substr(place.size() + 1);
  const std::size_t dot = rest.rfind('.');
  Group& group =
      part_named(section.groups, dot == std::string::npos ? std::string() : rest.substr(0, dot), &Group::name);
  group.open = comes_first(group.name);
  entry.name = rest.empty() ? entry.path : rest.substr(dot == std::string::npos ? 0 : dot + 1);
  group.entries.push_back(std::move(entry));
}

}  // namespace

std::vector<Section> sections(const Document& document) {
  std::vector<Section> all;
  for (const Key& key : keys()) {
    if (key.kind == Kind::table || key.kind == Kind::list) continue;
    if (key.dimension != 0 && key.dimension != document.scene.dimension) continue;
    for_each_position(document, key, [&](const Indices& indices) {
      add(all, document, {&key, path_at(key.path, indices), {}, key.binding.get(document, indices)});
    });
  }
  for (Section& section : all) {
    std::ranges::stable_sort(section.groups, {}, [](const Group& group) {
      return std::ranges::find(first_sections, group.name) - first_sections.begin();
    });
  }
  return all;
}

}  // namespace app
