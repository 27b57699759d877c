#include "ros/bag/node_of_topics.hpp"

#include <stdexcept>

namespace rigid_body_sim {
namespace {

bool hasEnding(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

void NodeOfTopics::addTopicOfBody(const std::string& topic, const std::string& name) {
  requireOne(name, topic, topic);
  requireOne("namespace", topic.substr(0, topic.size() - name.size()), topic);
}

void NodeOfTopics::addOwnTopic(const std::string& topic, const std::string& name) {
  requireOne("~" + name, topic, topic);
  const std::string ending = "/" + name;
  if (!hasEnding(topic, ending) || topic == ending) return;
  const std::string node = topic.substr(0, topic.size() - ending.size());
  requireOne("node", node, topic);
  requireOne("namespace", node.substr(0, node.rfind('/') + 1), topic);
}

void NodeOfTopics::requireOne(const std::string& what, const std::string& value,
                              const std::string& topic) {
  const Known& known = known_.emplace(what, Known{value, topic}).first->second;
  if (known.value != value)
    throw std::invalid_argument("must hold the inputs of one node, got " + known.topic + " and " +
                                topic + "; rosbag filter separates them");
}

}  // namespace rigid_body_sim
