#include "ros/messages/body_index.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

std::size_t bodyNamed(const std::string& name, const std::vector<Body>& bodies) {
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const Body& body) { return body.name == name; });
  if (found == bodies.end()) {
    std::vector<std::string> names;
    names.reserve(bodies.size());
    for (const Body& body : bodies) names.push_back(body.name);
    throw std::invalid_argument("unknown body '" + printable(name) +
                                "' (known: " + nameList(names) + ")" + didYouMean(name, names));
  }
  return static_cast<std::size_t>(found - bodies.begin());
}

}  // namespace rigid_body_sim
