#include "scene/files/xml_fault.hpp"

#include <algorithm>

#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

/// Where the stretch that begins at `at` ends: behind the closing mark, or with the text.
std::size_t behind(const std::string& xml, const char* mark, std::size_t at) {
  const std::size_t found = xml.find(mark, at);
  return found == std::string::npos ? xml.size() : found + std::string(mark).size();
}

/// The end of the tag that begins at `at`: its > outside quotes, or the end of the text; the next <
/// where that comes first, which it cannot in XML. So no parser sees tags where this sees quotes.
std::size_t tagEnd(const std::string& xml, std::size_t at) {
  char quote = 0;
  for (++at; at < xml.size() && xml[at] != '<'; ++at) {
    const char c = xml[at];
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      break;
  }
  return at;
}

}  // namespace

std::string xmlFault(const std::string& xml) {
  std::size_t depth = 0;
  for (std::size_t at = xml.find('<'); at < xml.size(); at = xml.find('<', at)) {
    if (xml.compare(at, 4, "<!--") == 0) {
      at = behind(xml, "-->", at + 4);
      continue;
    }
    if (xml.compare(at, 9, "<![CDATA[") == 0) {
      at = behind(xml, "]]>", at + 9);
      continue;
    }
    const char kind = at + 1 < xml.size() ? xml[at + 1] : '\0';
    at = tagEnd(xml, at);
    if (at < xml.size() && xml[at] == '<') return "a < within a tag";
    if (kind == '/')
      depth -= std::min<std::size_t>(depth, 1);
    else if (kind != '?' && kind != '!' && xml[at - 1] != '/' && ++depth > kMaxXmlDepth)
      return "elements nested deeper than " + std::to_string(kMaxXmlDepth) + " levels";
  }
  return "";
}

}  // namespace rigid_body_sim
