#include "app/scene/key_reference.h"

#include "app/scene/keys.h"
#include "app/scene/value_text.h"

namespace app {
namespace {

// A bar would end the cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string code(std::string_view text) {
  return "`" + std::string(text) + "`";
}

// A default that is a value, not words, is set as code.
std::string default_cell(const Key& key, const Document& blank) {
  const bool words = key.kind == Kind::table || key.kind == Kind::list || key.required || !key.absent.empty();
  const std::string text = default_text(key, blank);
  return words ? text : code(text);
}

std::string type_text(const Key& key) {
  std::string type = kind_text(key);
  if (key.dimension != 0) type += ", " + std::to_string(key.dimension) + "D only";
  return type;
}

std::string row(const Key& key, const Document& blank) {
  const std::string path(key.path);
  return "| " + code(path) + " | " + cell(type_text(key)) + " | " + cell(key.unit) + " | " + cell(key.range.text()) +
         " | " + cell(default_cell(key, blank)) + " | " + cell(key.meaning) + " |\n";
}

// The first name of a path: "body" of "body[].pin[].axes".
std::string_view part(const Key& key) {
  return std::string_view(key.path).substr(0, key.path.find_first_of(".["));
}

}  // namespace

std::string default_text(const Key& key, const Document& blank) {
  if (key.kind == Kind::table) return std::string(key.absent);
  if (key.required) return "required";
  if (!key.absent.empty()) return std::string(key.absent);
  if (key.kind == Kind::list) return "none";
  return value_text(key, *key.binding.get(blank, {}), 3);
}

std::string key_reference_markdown() {
  const Document blank = blank_document();
  std::string text;
  std::string_view current;
  for (const Key& key : keys()) {
    if (part(key) != current) {
      current = part(key);
      text += (text.empty() ? "" : "\n") + std::string("**") + std::string(current) + "**\n\n";
      text += "| key | type | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
    }
    text += row(key, blank);
  }
  return text;
}

}  // namespace app
