#include "app/base/json.h"

#include "app/base/text.h"

namespace app {

Json& Json::key(std::string_view name) {
  start_value();
  text_ += quoted_text(name);
  text_ += ": ";
  after_key_ = true;
  return *this;
}

Json& Json::value(std::string_view text) {
  start_value();
  text_ += quoted_text(text);
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

}  // namespace app
