#include "app/scene/value_text.h"

#include "app/base/number_text.h"
#include "app/base/text.h"

namespace app {
namespace {

std::string list(std::span<const double> numbers, bool integers = false) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) text += ", ";
    text += integers ? std::to_string(static_cast<std::int64_t>(numbers[i])) : number_literal(numbers[i]);
  }
  return text + "]";
}

// The first `shown` of every `stride` numbers.
std::string rows(std::span<const double> n, int stride, int shown) {
  std::string text = "[";
  for (std::size_t at = 0; at < n.size(); at += static_cast<std::size_t>(stride)) {
    text += (at > 0 ? ", " : "") + list(n.subspan(at, static_cast<std::size_t>(shown)));
  }
  return text + "]";
}

std::string list_text(const Key& key, std::span<const double> n, int dimension) {
  switch (key.kind) {
    case Kind::point:
    case Kind::direction:
      return list(n.first(dimension));
    case Kind::box:
      return "[" + list(n.first(dimension)) + ", " + list(n.subspan(3, dimension)) + "]";
    case Kind::matrix:
      return rows(n, dimension, dimension);
    case Kind::points:
      return rows(n, 3, dimension);
    case Kind::ball:
      return "[" + list(n.first(dimension)) + ", " + number_literal(n[3]) + "]";
    default:
      return list(n, key.kind == Kind::integers);
  }
}

}  // namespace

std::string number_literal(double x) {
  std::string text;
  append_number(text, x);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string value_text(const Key& key, const Value& value, int dimension) {
  if (const auto* x = std::get_if<bool>(&value)) return *x ? "true" : "false";
  if (const auto* x = std::get_if<double>(&value))
    return key.kind == Kind::joining && *x == 0 ? "true" : number_literal(*x);
  if (const auto* x = std::get_if<std::string>(&value)) return quoted_text(*x);
  if (const auto* x = std::get_if<std::int64_t>(&value)) {
    return key.kind == Kind::substeps && *x == 0 ? quoted_text("auto") : std::to_string(*x);
  }
  if (const auto* x = std::get_if<std::vector<std::string>>(&value)) {
    std::string list;
    for (const std::string& entry : *x) list.append(list.empty() ? "" : ", ").append(quoted_text(entry));
    return "[" + list + "]";
  }
  return list_text(key, std::get<std::vector<double>>(value), dimension);
}

}  // namespace app
