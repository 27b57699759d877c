#pragma once

#include <string>
#include <string_view>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Goes through the words of a text: what stands between blanks and ends of lines. A line ends with
/// a line feed, a carriage return, or both.
class WordReader {
 public:
  /// The text must outlive the reader. first_line: the number of its first line, for messages.
  explicit WordReader(const std::string& text, int first_line = 1)
      : at_(text.c_str()), end_(text.c_str() + text.size()), line_(first_line) {}

  /// The next word of this line; empty at its end.
  std::string_view wordOfLine();

  /// The next word, on this line or a later one; empty at the end of the text.
  std::string_view word();

  /// To the start of the next line; false where there is none.
  bool nextLine();

  /// A number, the nearest double whatever the locale; fails for a word that is none. Infinite for
  /// one that a double does not hold.
  double number(std::string_view word) const;

  /// Throws std::runtime_error: line <n>: must be <rule>, got '<word>'
  [[noreturn]] void fail(const std::string& rule, std::string_view got) const;

 private:
  const char* at_;
  const char* end_;
  int line_;
};

}  // namespace rigid_body_sim
