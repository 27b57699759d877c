#include "scene/files/word_reader.hpp"

#include <algorithm>
#include <stdexcept>

#include <stdlib.h>

#include "scene/files/classic_locale.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
bool endsWord(char c) { return isBlank(c) || isLineEnd(c); }

}  // namespace

std::string_view WordReader::wordOfLine() {
  at_ = std::find_if_not(at_, end_, isBlank);
  const char* const first = at_;
  at_ = std::find_if(at_, end_, endsWord);
  return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view WordReader::word() {
  std::string_view found = wordOfLine();
  while (found.empty() && nextLine()) found = wordOfLine();
  return found;
}

bool WordReader::nextLine() {
  at_ = std::find_if(at_, end_, isLineEnd);
  if (at_ == end_) return false;
  const bool is_pair = at_[0] == '\r' && at_ + 1 != end_ && at_[1] == '\n';
  at_ += is_pair ? 2 : 1;
  ++line_;
  return true;
}

double WordReader::number(std::string_view word) const {
  if (word.empty()) fail("a number", word);
  // a word ends at a blank or at the zero byte behind the text: strtod reads no further
  char* end = nullptr;
  const double value = strtod_l(word.data(), &end, classicLocale());
  if (end != word.data() + word.size()) fail("a number", word);
  return value;
}

void WordReader::fail(const std::string& rule, std::string_view got) const {
  throw std::runtime_error("mesh file cannot be read: line " + std::to_string(line_) +
                           ": must be " + rule + ", got '" + printable(std::string(got)) + "'");
}

}  // namespace rigid_body_sim
