#pragma once

#include <map>
#include <string>

namespace rigid_body_sim {

/// The node to which the topics of inputs in a bag belong, by their names: <body>/wrench lies in
/// its namespace, ~wrench below its own name.
class NodeOfTopics {
 public:
  /// Each throws std::invalid_argument with one line where the topic and one before are not of one
  /// node.
  /// name: as within the scene, such as box/wrench, with which the topic ends.
  void addTopicOfBody(const std::string& topic, const std::string& name);
  /// name: such as wrenches. The topic may have another, to which it was remapped: then it says of
  /// its node nothing but that it has one topic of that kind.
  void addOwnTopic(const std::string& topic, const std::string& name);

 private:
  void requireOne(const std::string& what, const std::string& value, const std::string& topic);

  struct Known {
    std::string value, topic;
  };
  std::map<std::string, Known> known_;  // by what it is
};

}  // namespace rigid_body_sim
