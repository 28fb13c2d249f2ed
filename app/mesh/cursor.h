// A place in the contents of a file: words, numbers and bytes are taken from it one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace app {

// Errors are thrown as FileError and point at the item that was taken last, by line or, in bytes, by offset.
// `what` names that item in the message ("number of nodes").
class Cursor {
 public:
  // The contents must outlive the cursor; name is the file's, for messages. A comment runs from the given
  // character to the end of its line ('\0': the format has no comments). A separator ends a word as a blank does, but
  // each separates two words, of which either may be empty.
  Cursor(std::string_view content, std::string_view name, char comment = '\0', char separator = '\0');

  const std::string& name() const { return name_; }
  std::size_t left() const { return content_.size() - position_; }

  // Skips white space and comments. True when nothing follows: in the file, or on the line.
  bool finished();
  bool line_finished();
  // To the start of the next line. What is left of this line is given back, without its end ("\n" or "\r\n").
  std::string_view rest_of_line();

  // The next word, on whatever line it stands.
  std::string_view word(std::string_view what);
  // The next word must be exactly this one.
  void expect(std::string_view text);
  // The same for formats that write words in capitals or not; the word that was read is given back in capitals.
  std::string keyword(std::string_view what);
  void expect_keyword(std::string_view text);
  // A text in double quotes that ends on its own line.
  std::string_view quoted(std::string_view what);
  // A whole number (of 64 bits): any, or from low to high.
  std::int64_t whole(std::string_view what);
  std::int64_t integer(std::string_view what, std::int64_t low, std::int64_t high);
  // A finite number.
  double real(std::string_view what);

  // From now on errors say the offset in bytes, not the line.
  void use_offsets() { offsets_ = true; }
  // Takes this text, which must follow here, blanks and line ends before it aside.
  void take(std::string_view text, std::string_view what);
  bool starts_with(std::string_view text) const { return content_.substr(position_).starts_with(text); }
  // What stands before the next such character, or the end of the file.
  std::string_view up_to(char end);
  // The character that follows, without taking it; '\0' at the end of the file.
  char peek() const { return left() > 0 ? content_[position_] : '\0'; }
  // Where the next item is searched, and back to such a place.
  std::size_t position() const { return position_; }
  void go_to(std::size_t position) { position_ = position; }
  // The next `size` bytes as they are.
  std::string_view bytes(std::size_t size, std::string_view what);
  // Goes on after the next occurrence of text; false, and nothing changes, when there is none.
  bool skip_past(std::string_view text);

  // Passes a number that was just read, and counts items of which each takes at least `bytes_each` of the file,
  // unless the rest of the file is too short for them. Nothing may be reserved for a count that was not checked.
  int checked_count(std::int64_t count, std::size_t bytes_each, std::string_view what) const;

  // Of the item that was taken last: its offset, and file and line (or offset) of such an item for a message.
  std::size_t item() const { return item_; }
  std::string where(std::size_t item) const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  std::string_view content_;
  std::string name_;
  char comment_, separator_;
  bool offsets_ = false;
  std::size_t position_ = 0;
  std::size_t item_ = 0;  // where the item that was taken last starts
};

// The numbers in a word: false when it is not, as a whole, such a number. A number that is too large for the type
// is not one, a real one that is too small to be told from zero is zero.
bool parse(std::string_view word, std::int64_t& value);
bool parse(std::string_view word, double& value);

// "word" in quotes for a message: shortened, and without what a terminal cannot show.
std::string quote(std::string_view word);

}  // namespace app
