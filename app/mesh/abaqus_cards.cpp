#include "app/mesh/abaqus_cards.h"

#include <algorithm>

#include "app/base/text.h"

namespace app {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view without_quotes(std::string_view text) {
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::string AbaqusCard::option(const std::string& name) const {
  const auto found = options.find(name);
  return found == options.end() ? std::string() : found->second;
}

bool abaqus_data_finished(Cursor& in) {
  while (!in.finished() && in.peek() == '*') {
    const std::size_t start = in.position();
    const std::string_view line = in.rest_of_line();
    if (line.starts_with("**")) continue;
    in.go_to(start);
    return true;
  }
  return in.finished();
}

AbaqusCard read_abaqus_card(Cursor& in) {
  const std::size_t start = in.position();
  in.word("a keyword");  // errors point at it
  in.go_to(start);
  std::string line(trimmed(in.rest_of_line()));
  while (line.ends_with(',') && in.left() > 0) line += trimmed(in.rest_of_line());
  AbaqusCard card;
  std::string_view rest = line;
  for (bool first = true; !rest.empty(); first = false) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view part = trimmed(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    const std::size_t equals = part.find('=');
    if (first) {
      card.keyword = in_capitals(part);
    } else {
      const std::string_view value = equals == part.npos ? std::string_view() : trimmed(part.substr(equals + 1));
      card.options[in_capitals(trimmed(part.substr(0, equals)))] = without_quotes(value);
    }
  }
  return card;
}

}  // namespace app
