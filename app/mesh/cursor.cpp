#include "app/mesh/cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "app/base/text.h"
#include "app/mesh/error.h"

namespace app {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
bool is_space(char c) {
  return is_blank(c) || c == '\n';
}

constexpr std::size_t longest_number = 64;  // letters

// from_chars knows no leading plus; formatted output of other programs does.
std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

bool parse(std::string_view word, std::int64_t& value) {
  word = without_plus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

bool parse(std::string_view word, double& value) {
  word = without_plus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) {
    // Fortran writes 1.0D+00.
    std::string text(word.substr(0, longest_number));
    const bool digits_before = end != word.data() && (*end == 'd' || *end == 'D');
    if (!digits_before || word.size() > longest_number) return false;
    text[static_cast<std::size_t>(end - word.data())] = 'e';
    return parse(text, value);
  }
  if (error == std::errc::result_out_of_range && (word.find("e-") != word.npos || word.find("E-") != word.npos)) {
    value = 0;
    return true;
  }
  return error == std::errc();
}

std::string quote(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return '"' + text + (word.size() > longest ? "...\"" : "\"");
}

Cursor::Cursor(std::string_view content, std::string_view name, char comment, char separator)
    : content_(content), name_(name), comment_(comment), separator_(separator) {}

std::string Cursor::where(std::size_t item) const {
  if (offsets_) return name_ + ": offset " + std::to_string(item);
  const auto line = 1 + std::count(content_.begin(), content_.begin() + static_cast<std::ptrdiff_t>(item), '\n');
  return name_ + ":" + std::to_string(line);
}

void Cursor::fail(const std::string& message) const {
  throw FileError(where(item_) + ": " + message);
}

bool Cursor::line_finished() {
  while (position_ < content_.size() && is_blank(content_[position_])) ++position_;
  return position_ == content_.size() || content_[position_] == '\n' ||
         (comment_ != '\0' && content_[position_] == comment_);
}

bool Cursor::finished() {
  while (line_finished()) {
    if (position_ == content_.size()) return true;
    rest_of_line();
  }
  return false;
}

std::string_view Cursor::rest_of_line() {
  const std::size_t end = std::min(content_.find('\n', position_), content_.size());
  std::string_view line = content_.substr(position_, end - position_);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  position_ = std::min(end + 1, content_.size());
  return line;
}

std::string_view Cursor::word(std::string_view what) {
  const bool none = finished();
  item_ = position_;
  if (none) fail("the file ends where " + std::string(what) + " should be");
  const auto separates = [this] { return separator_ != '\0' && content_[position_] == separator_; };
  while (position_ < content_.size() && !is_space(content_[position_]) && !separates()) ++position_;
  const std::string_view text = content_.substr(item_, position_ - item_);
  if (separator_ != '\0' && !line_finished() && separates()) ++position_;
  return text;
}

void Cursor::expect(std::string_view text) {
  const std::string_view found = word(text);
  if (found != text) fail(quote(found) + " stands where " + std::string(text) + " should be");
}

std::string Cursor::keyword(std::string_view what) {
  return in_capitals(word(what));
}

void Cursor::expect_keyword(std::string_view text) {
  const std::string found = keyword(text);
  if (found != in_capitals(text)) fail(quote(found) + " stands where " + std::string(text) + " should be");
}

std::string_view Cursor::quoted(std::string_view what) {
  const bool none = finished();
  item_ = position_;
  if (none) fail("the file ends where " + std::string(what) + " should be");
  const std::size_t line_end = std::min(content_.find_first_of("\r\n", position_), content_.size());
  const std::size_t end = content_.rfind('"', line_end);  // writers leave quotes inside of the text as they are
  if (content_[position_] != '"' || end == content_.npos || end <= position_)
    fail(std::string(what) + " should be in double quotes on one line");
  position_ = end + 1;
  return content_.substr(item_ + 1, end - item_ - 1);
}

std::int64_t Cursor::integer(std::string_view what, std::int64_t low, std::int64_t high) {
  const std::string_view text = word(what);
  std::int64_t value = 0;
  if (!parse(text, value) || value < low || value > high) {
    fail(std::string(what) + " is " + quote(text) + "; it should be a whole number from " + std::to_string(low) +
         " to " + std::to_string(high));
  }
  return value;
}

std::int64_t Cursor::whole(std::string_view what) {
  const std::string_view text = word(what);
  std::int64_t value = 0;
  if (!parse(text, value)) {
    fail(std::string(what) + " is " + quote(text) + "; it should be a whole number of 64 bits");
  }
  return value;
}

double Cursor::real(std::string_view what) {
  const std::string_view text = word(what);
  double value = 0;
  if (!parse(text, value) || !std::isfinite(value)) {
    fail(std::string(what) + " is " + quote(text) + "; it should be a finite number");
  }
  return value;
}

void Cursor::take(std::string_view text, std::string_view what) {
  finished();
  item_ = position_;
  if (!starts_with(text)) fail(std::string(what) + " should begin here with " + quote(text));
  position_ += text.size();
}

std::string_view Cursor::up_to(char end) {
  const std::size_t start = position_;
  position_ = std::min(content_.find(end, position_), content_.size());
  return content_.substr(start, position_ - start);
}

std::string_view Cursor::bytes(std::size_t size, std::string_view what) {
  item_ = position_;
  if (left() < size) fail("the file ends within " + std::string(what));
  position_ += size;
  return content_.substr(item_, size);
}

bool Cursor::skip_past(std::string_view text) {
  const std::size_t found = content_.find(text, position_);
  if (found == content_.npos) return false;
  position_ = found + text.size();
  return true;
}

int Cursor::checked_count(std::int64_t count, std::size_t bytes_each, std::string_view what) const {
  // The last item may do without the blank that is counted as part of every item of text.
  const std::size_t fit = (left() + 1) / bytes_each;
  const auto most = std::min<std::int64_t>(static_cast<std::int64_t>(fit), std::numeric_limits<int>::max());
  if (count < 0 || count > most) {
    fail(std::string(what) + " is " + std::to_string(count) + ", but the " + std::to_string(left()) +
         " bytes that are left in the file have room for 0 to " + std::to_string(most));
  }
  return static_cast<int>(count);
}

}  // namespace app
