#include "scene/readers/plain_yaml.hpp"

#include <cstddef>
#include <vector>

#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

bool isWordByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '-' && c <= '9') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '+';
}

/// Reads line by line. Each member that returns a bool says whether the text is plain so far.
class PlainReader {
 public:
  PlainReader(std::string_view text, const std::function<void(const YamlEvent&)>& take)
      : text_(text), take_(take) {}

  bool read() {
    give(YAML_DOCUMENT_START_EVENT);
    for (; at_ < text_.size(); ++line_) {
      if (!readLine()) return false;
      ++at_;  // the end of the line
    }
    if (blocks_.empty() || awaits_) return false;
    while (!blocks_.empty()) close();
    return true;
  }

 private:
  /// A list or mapping whose entries begin lines, all in one column.
  struct Block {
    std::size_t column;
    bool list;
  };

  void give(yaml_event_type_t type, std::string_view text = {}) {
    YamlEvent event;
    event.type = type;
    event.line = line_;
    event.text = text;
    take_(event);
  }

  void open(std::size_t column, bool list) {
    blocks_.push_back({column, list});
    give(list ? YAML_SEQUENCE_START_EVENT : YAML_MAPPING_START_EVENT);
  }
  void close() {
    give(blocks_.back().list ? YAML_SEQUENCE_END_EVENT : YAML_MAPPING_END_EVENT);
    blocks_.pop_back();
  }

  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\n';
  }
  void skipSpaces() {
    while (peek() == ' ') ++at_;
  }
  std::size_t column() const { return at_ - line_start_; }

  bool readLine() {
    line_start_ = at_;
    skipSpaces();
    if (peek() == '\n' || peek() == '#') return endLine();
    if (column() == 0 && text_.substr(at_, 3) == "...") return false;  // the end of a document
    const bool item = peek() == '-' && (peek(1) == ' ' || peek(1) == '\n');
    if (!findBlock(item)) return false;
    awaits_ = false;
    return item ? readItem() : readKey();
  }

  /// Makes the block that the line belongs to the last one, by its column.
  bool findBlock(bool item) {
    const std::size_t here = column();
    if (awaits_) {
      // entries of a list may begin in the column of the key that they belong to
      const bool below_key = item && !blocks_.empty() && !blocks_.back().list;
      if (!blocks_.empty() && here < blocks_.back().column + (below_key ? 0 : 1)) return false;
      open(here, item);
      return true;
    }
    while (!blocks_.empty() && blocks_.back().column > here) close();
    // after a list in the column of its key, the next key
    if (blocks_.size() > 1 && !item && blocks_.back().list &&
        blocks_[blocks_.size() - 2].column == here)
      close();
    return !blocks_.empty() && blocks_.back().column == here && blocks_.back().list == item;
  }

  bool readItem() {
    ++at_;
    skipSpaces();
    if (endsLine()) return awaitNextLine();
    const std::size_t begin = at_;
    const bool key = skipWord() && peek() == ':';
    at_ = begin;
    if (!key) return readValue() && endLine();
    open(column(), false);
    return readKey();
  }

  bool readKey() {
    if (!giveWord() || !skipColon()) return false;
    if (endsLine()) return awaitNextLine();
    return readValue() && endLine();
  }

  bool awaitNextLine() {
    awaits_ = true;
    return endLine();
  }

  /// After a key; in front of its value or the end of the line.
  bool skipColon() {
    if (peek() != ':' || (peek(1) != ' ' && peek(1) != '\n')) return false;
    ++at_;
    skipSpaces();
    return true;
  }

  bool endsLine() const { return peek() == '\n' || peek() == '#'; }

  /// Of the line nothing may be left but a comment.
  bool endLine() {
    const std::size_t begin = at_;
    skipSpaces();
    const bool parted = at_ > begin || begin == line_start_ || text_[begin - 1] == ' ';
    if (peek() == '#' && parted)
      while (peek() >= ' ' && peek() <= '~') ++at_;
    return peek() == '\n';
  }

  bool skipWord() {
    const char first = peek(), second = peek(1);
    const bool dash = first == '-' && second != '.' && !(second >= '0' && second <= '9');
    if (dash || !isWordByte(first)) return false;
    const std::size_t begin = at_;
    while (isWordByte(peek())) ++at_;
    return at_ - begin <= kMaxWordBytes;
  }

  bool giveWord() {
    const std::size_t begin = at_;
    if (!skipWord()) return false;
    give(YAML_SCALAR_EVENT, text_.substr(begin, at_ - begin));
    return true;
  }

  bool readValue() { return peek() == '{' || peek() == '[' ? readFlow() : giveWord(); }

  /// In braces or brackets.
  bool readFlow() {
    const bool list = peek() == '[';
    const char end = list ? ']' : '}';
    if (++flow_depth_ > kMaxDepth) return false;
    give(list ? YAML_SEQUENCE_START_EVENT : YAML_MAPPING_START_EVENT);
    do {
      ++at_;
      skipSpaces();
      if (peek() == end) break;  // empty, or after a last comma
      if (!list && !(giveWord() && skipColon())) return false;
      if (!readValue()) return false;
      skipSpaces();
    } while (peek() == ',');
    if (peek() != end) return false;
    ++at_;
    --flow_depth_;
    give(list ? YAML_SEQUENCE_END_EVENT : YAML_MAPPING_END_EVENT);
    return true;
  }

  static constexpr std::size_t kMaxWordBytes = 255;  ///< YAML bounds keys by 1024 characters

  std::string_view text_;
  const std::function<void(const YamlEvent&)>& take_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
  std::vector<Block> blocks_;
  bool awaits_ = true;  ///< a value, or the document, which begins on a line that follows
  std::size_t flow_depth_ = 0;
};

}  // namespace

bool readPlainYaml(std::string_view text, const std::function<void(const YamlEvent&)>& take) {
  return PlainReader(text, take).read();
}

}  // namespace rigid_body_sim
