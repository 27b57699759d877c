#include "scene/meshes/dae_document.hpp"

#include <charconv>
#include <cstring>
#include <stdexcept>

#include "scene/files/word_reader.hpp"
#include "scene/files/xml_fault.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

std::string textOf(const DaeElement& element) {
  std::string text;
  for (const auto* child = element.FirstChild(); child; child = child->NextSibling())
    if (const tinyxml2::XMLText* part = child->ToText()) text += part->Value();
  return text;
}

std::string attributeOf(const DaeElement& element, const char* name) {
  const char* const value = element.Attribute(name);
  if (!value) failAt(element, std::string("missing attribute ") + name);
  return value;
}

/// A number without a sign, in decimal digits.
bool parseIndex(std::string_view word, std::size_t& index) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  return error == std::errc() && end == word.data() + word.size();
}

/// All elements in the order of the file: the next below, beside, or beside one above.
const DaeElement* nextElement(const DaeElement* element) {
  if (const DaeElement* child = element->FirstChildElement()) return child;
  while (element && !element->NextSiblingElement()) {
    const tinyxml2::XMLNode* const parent = element->Parent();
    element = parent ? parent->ToElement() : nullptr;
  }
  return element ? element->NextSiblingElement() : nullptr;
}

}  // namespace

DaeDocument::DaeDocument(const std::string& xml) {
  const std::string fault = xmlFault(xml);
  if (!fault.empty()) throw std::runtime_error("mesh file cannot be read: " + fault);
  if (document_.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS)
    throw std::runtime_error("mesh file cannot be read: line " +
                             std::to_string(document_.ErrorLineNum()) + ": no well-formed XML (" +
                             tinyxml2::XMLDocument::ErrorIDToName(document_.ErrorID()) + ")");
  if (!document_.RootElement() || !isNamed(root(), "COLLADA"))
    throw std::runtime_error("mesh file cannot be read: its root must be the element COLLADA");
  for (const DaeElement* element = &root(); element; element = nextElement(element))
    if (const char* id = element->Attribute("id")) by_id_.emplace(id, element);
}

const DaeElement& DaeDocument::referred(const DaeElement& from, const char* attribute) const {
  const std::string url = attributeOf(from, attribute);
  const auto found = url.empty() || url[0] != '#' ? by_id_.end() : by_id_.find(url.substr(1));
  if (found == by_id_.end())
    failAt(from, std::string(attribute) + " must name an element of this file by #id, got '" +
                     printable(url) + "'");
  return *found->second;
}

const DaeElement& DaeDocument::referred(const DaeElement& from, const char* attribute,
                                        const char* name) const {
  const DaeElement& found = referred(from, attribute);
  if (!isNamed(found, name))
    failAt(from,
           std::string(attribute) + " must name a " + name + ", got a " + printable(found.Name()));
  return found;
}

void failAt(const DaeElement& element, const std::string& what) {
  throw std::runtime_error("mesh file cannot be read: line " +
                           std::to_string(element.GetLineNum()) + ": " + printable(element.Name()) +
                           ": " + what);
}

bool isNamed(const DaeElement& element, const char* name) {
  return std::strcmp(element.Name(), name) == 0;
}

const DaeElement& requiredChild(const DaeElement& parent, const char* name) {
  const DaeElement* const child = parent.FirstChildElement(name);
  if (!child) failAt(parent, std::string("missing element ") + name);
  return *child;
}

std::vector<double> numbersIn(const DaeElement& element, NumberPrecision* precision) {
  const std::string text = textOf(element);
  WordReader words(text, element.GetLineNum());
  std::vector<double> numbers;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    numbers.push_back(words.number(word));
    if (precision) precision->add(word, numbers.back());
  }
  return numbers;
}

std::vector<double> numbersIn(const DaeElement& element, std::size_t count) {
  std::vector<double> numbers = numbersIn(element);
  if (numbers.size() != count)
    failAt(element,
           "must be " + std::to_string(count) + " numbers, got " + std::to_string(numbers.size()));
  return numbers;
}

std::vector<std::size_t> indicesIn(const DaeElement& element) {
  const std::string text = textOf(element);
  WordReader words(text, element.GetLineNum());
  std::vector<std::size_t> indices;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    indices.push_back(0);
    if (!parseIndex(word, indices.back())) words.fail("an index", word);
  }
  return indices;
}

std::size_t indexAttribute(const DaeElement& element, const char* name, std::size_t otherwise) {
  const char* const value = element.Attribute(name);
  std::size_t index = otherwise;
  if (value && !parseIndex(value, index))
    failAt(element, std::string(name) + " must be a count, got '" + printable(value) + "'");
  return index;
}

}  // namespace rigid_body_sim
