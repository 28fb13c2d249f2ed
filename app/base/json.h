// Writes JSON text (RFC 8259), indented, value by value in the order of the calls.
#pragma once

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include "app/base/number_text.h"

namespace app {

// The caller keeps objects and arrays balanced.
class Json {
 public:
  // The name of the next value, inside an object.
  Json& key(std::string_view name);
  Json& open_object() { return open('{'); }
  Json& close_object() { return close('}'); }
  Json& open_array() { return open('['); }
  Json& close_array() { return close(']'); }

  Json& value(std::string_view text);
  Json& value(const char* text) { return value(std::string_view(text)); }
  Json& value(bool truth);
  // JSON knows neither infinity nor NaN: they become null.
  template <typename Number>
  requires std::integral<Number> || std::floating_point<Number> Json& value(Number number) {
    start_value();
    if (std::isfinite(static_cast<double>(number))) {
      append_number(text_, number);
    } else {
      text_ += "null";
    }
    return *this;
  }

  // JSON text that somebody else has written.
  Json& raw(std::string_view json);

  template <typename Value>
  Json& member(std::string_view name, const Value& content) {
    return key(name).value(content);
  }

  const std::string& text() const { return text_; }

 private:
  Json& open(char bracket);
  Json& close(char bracket);
  void start_value();  // comma, line break and indent before a value or a name

  std::string text_;
  int depth_ = 0;
  bool first_ = true;       // nothing yet in the innermost object or array
  bool after_key_ = false;  // the value goes on the line of its name
};

}  // namespace app
