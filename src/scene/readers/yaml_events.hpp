#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <yaml.h>

namespace rigid_body_sim {

/// What libyaml finds next in a text. The views last as long as the call that gets them.
struct YamlEvent {
  yaml_event_type_t type = YAML_NO_EVENT;
  int line = 0;  ///< where it begins; the first is 1
  bool has_anchor = false;
  std::string_view tag;
  std::string_view text;  ///< of a scalar
  bool quoted = false;    ///< a scalar that is not plain

  /// A plain scalar that stands for no value: nothing, ~ or null.
  bool isNull() const;
};

/// Gives the events of the text one after the other to `take`. Throws SceneError where the text is
/// not YAML; source_name stands for the file.
void readYamlEvents(const std::string& yaml_text, const std::string& source_name,
                    const std::function<void(const YamlEvent&)>& take);

}  // namespace rigid_body_sim
