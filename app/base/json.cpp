#include "app/base/json.h"

namespace app {

Json& Json::key(std::string_view name) {
  start_value();
  append_string(name);
  text_ += ": ";
  after_key_ = true;
  return *this;
}

Json& Json::value(std::string_view text) {
  start_value();
  append_string(text);
  return *this;
}

Json& Json::value(bool truth) {
  start_value();
  text_ += truth ? "true" : "false";
  return *this;
}

Json& Json::raw(std::string_view json) {
  start_value();
  text_ += json;
  return *this;
}

Json& Json::open(char bracket) {
  start_value();
  text_ += bracket;
  ++depth_;
  first_ = true;
  return *this;
}

Json& Json::close(char bracket) {
  --depth_;
  if (!first_) text_ += '\n' + std::string(2 * static_cast<std::size_t>(depth_), ' ');
  text_ += bracket;
  first_ = false;
  if (depth_ == 0) text_ += '\n';
  return *this;
}

void Json::start_value() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (!first_) text_ += ',';
  if (depth_ > 0) text_ += '\n' + std::string(2 * static_cast<std::size_t>(depth_), ' ');
  first_ = false;
}

void Json::append_string(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  text_ += '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text_ += {'\\', c};
    } else if (c == '\n') {
      text_ += "\\n";
    } else if (code < 0x20) {
      text_ += {'\\', 'u', '0', '0', digits[code >> 4], digits[code & 15]};
    } else {
      text_ += c;
    }
  }
  text_ += '"';
}

}  // namespace app
