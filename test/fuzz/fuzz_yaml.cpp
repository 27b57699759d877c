#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "support/yaml_event_list.hpp"

/// A text that the reader of plain YAML takes gives the events of libyaml.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim::test;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto plain = plainEvents(text);
  if (!plain) return 0;
  if (*plain != libyamlEvents(text)) std::abort();
  return 0;
}
