#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include <tinyxml2.h>

#include "scene/meshes/number_precision.hpp"

namespace rigid_body_sim {

using DaeElement = tinyxml2::XMLElement;

/// The elements of a COLLADA file, found by what they are referred to. Every function throws
/// std::runtime_error with one line, "mesh file cannot be read: line <n>: …", for what it cannot
/// do.
class DaeDocument {
 public:
  explicit DaeDocument(const std::string& xml);

  const DaeElement& root() const { return *document_.RootElement(); }

  /// The element that an attribute names by "#id"; it must be one of that name.
  const DaeElement& referred(const DaeElement& from, const char* attribute, const char* name) const;

  /// The same, of any name.
  const DaeElement& referred(const DaeElement& from, const char* attribute) const;

 private:
  tinyxml2::XMLDocument document_;
  std::unordered_map<std::string, const DaeElement*> by_id_;
};

[[noreturn]] void failAt(const DaeElement& element, const std::string& what);

bool isNamed(const DaeElement& element, const char* name);

/// The first child of a name; a child that is missing is a fault.
const DaeElement& requiredChild(const DaeElement& parent, const char* name);

/// The numbers in the text of an element; as many as `count`, where that is given.
std::vector<double> numbersIn(const DaeElement& element, NumberPrecision* precision = nullptr);
std::vector<double> numbersIn(const DaeElement& element, std::size_t count);

/// The indices in the text of an element.
std::vector<std::size_t> indicesIn(const DaeElement& element);

/// An attribute that counts or numbers; the given value where there is none.
std::size_t indexAttribute(const DaeElement& element, const char* name, std::size_t otherwise);

}  // namespace rigid_body_sim
