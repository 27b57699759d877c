#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/readers/plain_yaml.hpp"

namespace rigid_body_sim::test {

using YamlEventList = std::vector<std::string>;

/// What a reader of YAML finds, as "kind line text"; of what ends a list or mapping the kind alone.
inline void append(const YamlEvent& event, YamlEventList& list) {
  const std::string kind = std::to_string(event.type);
  switch (event.type) {
    case YAML_DOCUMENT_START_EVENT:
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
      return list.push_back(kind);
    case YAML_STREAM_START_EVENT:
    case YAML_STREAM_END_EVENT:
    case YAML_DOCUMENT_END_EVENT:
      return;
    default:
      list.push_back(kind + " " + std::to_string(event.line) + (event.quoted ? " quoted " : " ") +
                     (event.has_anchor ? "&" : "") + std::string(event.tag) +
                     std::string(event.text));
  }
}

/// None where the text is not plain.
inline std::optional<YamlEventList> plainEvents(const std::string& text) {
  YamlEventList list;
  const bool plain = readPlainYaml(text, [&](const YamlEvent& event) { append(event, list); });
  return plain ? std::optional<YamlEventList>(list) : std::nullopt;
}

/// "not YAML" where it is none.
inline YamlEventList libyamlEvents(const std::string& text) {
  YamlEventList list;
  try {
    readYamlEvents(text, "", [&](const YamlEvent& event) { append(event, list); });
  } catch (const SceneError&) {
    return {"not YAML"};
  }
  return list;
}

}  // namespace rigid_body_sim::test
