#include "scene/readers/yaml_events.hpp"

#include <algorithm>
#include <new>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// The line of a text; the first is 0.
std::string_view lineOf(std::string_view text, std::size_t line) {
  for (; line > 0; --line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

bool isIndentedByTab(std::string_view line) {
  return line.substr(0, line.find_first_not_of(" \t")).find('\t') != std::string_view::npos;
}

std::string_view viewOf(const unsigned char* text, std::size_t size) {
  return {reinterpret_cast<const char*>(text), size};
}

std::string_view tagOf(const unsigned char* tag) {
  return tag ? std::string_view(reinterpret_cast<const char*>(tag)) : std::string_view();
}

YamlEvent toEvent(const yaml_event_t& from) {
  YamlEvent event;
  event.type = from.type;
  event.line = static_cast<int>(from.start_mark.line) + 1;
  if (from.type == YAML_SCALAR_EVENT) {
    const auto& scalar = from.data.scalar;
    event.has_anchor = scalar.anchor != nullptr;
    event.tag = tagOf(scalar.tag);
    event.text = viewOf(scalar.value, scalar.length);
    event.quoted = scalar.style != YAML_PLAIN_SCALAR_STYLE;
  } else if (from.type == YAML_SEQUENCE_START_EVENT) {
    event.has_anchor = from.data.sequence_start.anchor != nullptr;
    event.tag = tagOf(from.data.sequence_start.tag);
  } else if (from.type == YAML_MAPPING_START_EVENT) {
    event.has_anchor = from.data.mapping_start.anchor != nullptr;
    event.tag = tagOf(from.data.mapping_start.tag);
  }
  return event;
}

/// libyaml's parser; throws where the text is not YAML.
class Parser {
 public:
  Parser(const std::string& text, const std::string& source) : text_(text), source_(source) {
    if (!yaml_parser_initialize(&parser_)) throw std::bad_alloc();
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                                 text.size());
  }
  ~Parser() {
    yaml_event_delete(&event_);
    yaml_parser_delete(&parser_);
  }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  YamlEvent next() {
    yaml_event_delete(&event_);
    if (!yaml_parser_parse(&parser_, &event_)) fail();
    return toEvent(event_);
  }

 private:
  [[noreturn]] void fail() const {
    if (parser_.error == YAML_MEMORY_ERROR) throw std::bad_alloc();
    // the reader of bytes knows no lines
    const std::size_t line = parser_.error == YAML_READER_ERROR ? lineAt(parser_.problem_offset)
                                                                : parser_.problem_mark.line;
    const std::string reason = parser_.problem ? parser_.problem : "cannot be read";
    const std::string text = isIndentedByTab(lineOf(text_, line))
                                 ? "this line is indented by a tab; YAML indents by spaces"
                                 : printable(reason) + whereItMayBe(line);
    throw SceneError(source_, static_cast<int>(line) + 1, "not YAML: " + text);
  }

  /// libyaml stops where the text cannot go on, which may be lines below the mistake: where what it
  /// was reading begins, or at a line that it read as words alone.
  std::string whereItMayBe(std::size_t line) const {
    const std::size_t begin = parser_.context_mark.line;
    if (parser_.context && begin < line)
      return std::string(", ") + parser_.context + " that begins in line " +
             std::to_string(begin + 1);
    if (parser_.context || parser_.error != YAML_SCANNER_ERROR || line == 0) return "";
    const std::string_view before = lineOf(text_, line - 1);
    const bool is_words = before.find_first_not_of(' ') != std::string_view::npos &&
                          before.find_first_of(":#") == std::string_view::npos;
    return is_words ? "; or line " + std::to_string(line) + " lacks a ':'" : "";
  }

  std::size_t lineAt(std::size_t byte) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text_.size()));
    return static_cast<std::size_t>(std::count(text_.begin(), end, '\n'));
  }

  const std::string& text_;
  const std::string& source_;
  yaml_parser_t parser_ = {};
  yaml_event_t event_ = {};
};

}  // namespace

bool YamlEvent::isNull() const {
  return !quoted &&
         (text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL");
}

void readYamlEvents(const std::string& yaml_text, const std::string& source_name,
                    const std::function<void(const YamlEvent&)>& take) {
  Parser parser(yaml_text, source_name);
  for (YamlEvent event; event.type != YAML_STREAM_END_EVENT;) {
    event = parser.next();
    take(event);
  }
}

}  // namespace rigid_body_sim
