#include "scene/study/varied_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/files/number_text.hpp"
#include "scene/readers/read_scene.hpp"
#include "scene/readers/readers.hpp"
#include "scene/study/scene_path.hpp"
#include "scene/study/yaml_text.hpp"

namespace rigid_body_sim {
namespace {

SceneValue::Word wordOf(const YamlNode& node) {
  return {std::string(node.text()), node.quoted(), numberIn(node)};
}

SceneValue valueOf(const YamlNode& node) {
  SceneValue value;
  value.is_list = node.kind() == YamlNode::Kind::kList;
  if (!value.is_list) {
    value.words.push_back(wordOf(node));
    return value;
  }
  for (const YamlNode& item : node.children()) value.words.push_back(wordOf(item));
  return value;
}

/// Makes the node of the document the value, whose texts it refers to. A list of as many items as
/// before takes their place: a sweep sets values a million times.
void place(const SceneValue& value, YamlNode& node, YamlDocument& document) {
  const auto setWord = [](const SceneValue::Word& word, YamlNode& at) {
    at.setScalar(word.text, word.quoted);
  };
  const std::size_t count = value.words.size();
  if (!value.is_list) return setWord(value.words.front(), node);
  if (node.kind() != YamlNode::Kind::kList || node.children().size() != count)
    node.setChildren(YamlNode::Kind::kList, document.makeNodes(count));
  for (std::size_t i = 0; i < count; ++i) {
    YamlNode& item = node.children()[i] = YamlNode();
    item.setPlace("", node.line());
    setWord(value.words[i], item);
  }
}

[[noreturn]] void failPath(const Study& study, const Varied& varied, const std::string& message) {
  throw SceneError(study.source, varied.line,
                   "vary: '" + printable(varied.path) + "' " + oneLine(message));
}

/// Keys that a scene may leave out and a study vary all the same, with what they then are. They
/// last: the nodes that get these values refer to their texts.
const std::vector<std::pair<std::string, SceneValue>>& optionalKeys() {
  static const Scene scene;
  static const std::vector<std::pair<std::string, SceneValue>> keys = {
      {"tolerance", SceneValue::of(scene.tolerance)},
      {"horizon", SceneValue::of(scene.horizon)},
      {"integrator", {{{scene.integrator}}, false}}};
  return keys;
}

}  // namespace

VariedScene::VariedScene(const std::string& text, ReadContext context, const Study& study)
    : document_(parseYaml(text, context.source)), context_(std::move(context)) {
  scene_ = readScene(document_.root, context_);
  addDefaults(study);
  // a tolerance that is stated is not the default: with all that is varied in it, the scene is the
  // same whatever was drawn before
  if (defaults_added_) scene_ = readScene(document_.root, context_);
  for (const Varied& varied : study.vary) addSlot(varied, study);
  refuseOverlaps(study);
}

/// Orientations of bodies, and keys of the scene, that are left out and varied. First of all, since
/// nodes move.
void VariedScene::addDefaults(const Study& study) {
  static const SceneValue identity{{{"0"}, {"0"}, {"0"}, {"1"}}, true};
  const auto add = [&](YamlNode& mapping, const std::string& key, const SceneValue& value) {
    if (mapping.kind() != YamlNode::Kind::kMapping || mapping.find(key)) return;
    const YamlNodes<YamlNode> before = mapping.children();
    const YamlNodes<YamlNode> after = document_.makeNodes(before.size() + 1);
    YamlNode& node = *std::copy(before.begin(), before.end(), after.begin());
    node.setPlace(document_.keep(key), mapping.line());
    place(value, node, document_);
    mapping.setChildren(YamlNode::Kind::kMapping, after);
    defaults_added_ = true;
  };
  for (const Varied& varied : study.vary) {
    for (const auto& [key, value] : optionalKeys())
      if (varied.path == key) add(document_.root, key, value);
    const std::vector<PathStep> steps = stepsOf(varied.path);
    if (steps.size() != 3 || steps[0].name != "bodies" || steps[2].name != "orientation") continue;
    YamlNode* bodies = follow(document_.root, steps[0]);
    YamlNode* body = bodies ? follow(*bodies, steps[1]) : nullptr;
    if (body) add(*body, "orientation", identity);
  }
}

void VariedScene::addSlot(const Varied& varied, const Study& study) {
  Slot slot;
  slot.path = varied.path;
  slot.node = nodeAt(document_.root, varied.path);
  if (!slot.node)
    failPath(study, varied,
             "is not in " + context_.source + "; the nearest that is: '" +
                 nearestOf(varied.path, pathsOf(document_.root)) +
                 "'; a key that the scene leaves out must be written into it first");
  const YamlNodes<YamlNode> items = slot.node->children();
  const bool holds_mappings = slot.node->kind() == YamlNode::Kind::kMapping ||
                              std::any_of(items.begin(), items.end(), [](const YamlNode& n) {
                                return n.kind() != YamlNode::Kind::kScalar;
                              });
  const bool orientation = std::holds_alternative<RotationDistribution>(varied.distribution);
  if (holds_mappings && !orientation)
    failPath(study, varied, "holds more than a value or a list of values; name one within it");
  const std::vector<PathStep> steps = stepsOf(varied.path);
  if (steps.back().name == "name") failPath(study, varied, "is a name, which cannot vary");
  if (orientation && steps.back().name != "orientation")
    failPath(study, varied, "must be an orientation for a rotation");
  if (orientation) {
    Entry root(context_, document_.root);
    const Quaterniond q = readOrientation(root.child(*slot.node));
    slot.own = SceneValue::of({q.x(), q.y(), q.z(), q.w()});
  } else {
    slot.own = valueOf(*slot.node);
  }
  slot.now = slot.own;
  findPart(slot);
  slots_.push_back(std::move(slot));
}

void VariedScene::refuseOverlaps(const Study& study) const {
  const auto lies = [](const YamlNode* inner, const YamlNode& outer) {
    const YamlNodes<const YamlNode> within = outer.children();
    return std::any_of(within.begin(), within.end(),
                       [&](const YamlNode& child) { return &child == inner; });
  };
  for (std::size_t i = 0; i < slots_.size(); ++i)
    for (std::size_t j = 0; j < slots_.size(); ++j)
      if (i != j && (slots_[i].node == slots_[j].node || lies(slots_[i].node, *slots_[j].node)))
        failPath(study, study.vary[i],
                 (slots_[i].node == slots_[j].node ? "is the same value as '" : "is part of '") +
                     slots_[j].path + "', which varies, too");
}

void VariedScene::findPart(Slot& slot) {
  static const std::vector<std::pair<std::string, Part>> lists = {{"bodies", Part::kBody},
                                                                  {"forces", Part::kForce},
                                                                  {"wrenches", Part::kWrench},
                                                                  {"commands", Part::kCommand}};
  const std::vector<PathStep> steps = stepsOf(slot.path);
  for (const auto& [key, part] : lists) {
    if (steps.size() < 3 || steps[0].name != key || steps.back().name == "type") continue;
    YamlNode& list = *follow(document_.root, steps[0]);
    slot.part = part;
    slot.entry = static_cast<std::size_t>(follow(list, steps[1]) - list.children().begin());
    if (part == Part::kWrench) slot.key = steps[2].name;
    slot.plain = PlainNumber::at(scene_, steps, slot.entry);
    for (const char* own : {"mass", "position", "orientation", "twist"})
      if (part == Part::kBody && steps[2].name == own) slot.key = own;
  }
}

void VariedScene::set(std::size_t index, const SceneValue& value) {
  Slot& slot = slots_[index];
  if (slot.now == value) return;
  slot.now = value;
  placeNow(slot);
}

/// In the memory of the number before it.
void VariedScene::set(std::size_t index, double x) {
  Slot& slot = slots_[index];
  if (slot.now.is_list || !std::isfinite(x)) return set(index, SceneValue::of(x));
  SceneValue::Word& word = slot.now.words.front();
  word.text.clear();
  appendNumber(x, word.text);
  word.quoted = false;
  word.number = x;
  placeNow(slot);
}

void VariedScene::placeNow(Slot& slot) {
  place(slot.now, *slot.node, document_);
  slot.is_read = false;
}

const Scene& VariedScene::scene() {
  const bool whole = std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) {
    return !slot.is_read && slot.part == Part::kWhole;
  });
  if (whole) {
    scene_ = readScene(document_.root, context_);
  } else {
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (!slots_[i].is_read && !setPlain(slots_[i]) && !isReadBefore(i)) readEntry(slots_[i]);
    context_.notices.clear();
  }
  for (Slot& slot : slots_) slot.is_read = true;
  return scene_;
}

/// False where the value has to be read from the file.
bool VariedScene::setPlain(const Slot& slot) {
  const SceneValue& value = slot.now;
  return slot.plain && !value.is_list && value.words.front().number &&
         slot.plain->set(*value.words.front().number, scene_);
}

/// Whether a slot before this one, whose value changed, too, is read together with it.
bool VariedScene::isReadBefore(std::size_t index) const {
  const Slot& slot = slots_[index];
  return std::any_of(slots_.data(), slots_.data() + index, [&](const Slot& s) {
    return !s.is_read && !s.plain && s.part == slot.part && s.entry == slot.entry &&
           s.key == slot.key;
  });
}

void VariedScene::readEntry(const Slot& slot) {
  const Entry root(context_, document_.root);
  if (slot.part == Part::kBody && !slot.key.empty()) {
    const Entry list = root.child(*document_.root.find("bodies"));
    if (readBodyKey(list.item(slot.entry), slot.key, scene_.bodies[slot.entry])) return;
  }
  if (slot.part == Part::kWrench) {
    const Entry list = root.child(*document_.root.find("wrenches"));
    return readWrenchKey(list.item(slot.entry), slot.key, scene_.wrenches[slot.entry]);
  }
  const auto read = [&](const char* key, auto& entries, const auto& reader) {
    const Entry list = root.child(*document_.root.find(key));
    entries[slot.entry] = reader(list.item(slot.entry));
  };
  if (slot.part == Part::kBody) read("bodies", scene_.bodies, readBody);
  if (slot.part == Part::kForce) read("forces", scene_.forces, readForce);
  if (slot.part == Part::kCommand) read("commands", scene_.commands, readCommand);
}

std::string VariedScene::yaml() const { return yamlText(document_.root, context_.directory); }

}  // namespace rigid_body_sim
