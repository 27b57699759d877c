#include <algorithm>

#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

const std::vector<Key<WrenchDef>>& wrenchKeys() {
  static const std::vector<Key<WrenchDef>> keys = {
      {"body", [](const Entry& e, WrenchDef& w) { w.body = readText(e); }, true},
      {"point", [](const Entry& e, WrenchDef& w) { w.point = readVector3(e, "m"); }},
      {"point_frame", [](const Entry& e, WrenchDef& w) { w.point_frame = readTextOrNone(e); }},
      {"frame", [](const Entry& e, WrenchDef& w) { w.frame = readText(e); }, true},
      {"force", [](const Entry& e, WrenchDef& w) { w.force = readVector3(e, "N"); }},
      {"torque", [](const Entry& e, WrenchDef& w) { w.torque = readVector3(e, "N m"); }},
      {"start", [](const Entry& e, WrenchDef& w) { w.start = readNotNegative(e, "s"); }},
      {"duration", [](const Entry& e, WrenchDef& w) { w.duration = readDuration(e); }, true},
  };
  return keys;
}

}  // namespace

WrenchDef readWrench(const Entry& list_item) {
  const Entry entry = list_item.as(list_item.key());
  WrenchDef wrench;
  readMapping(entry, wrenchKeys(), wrench);
  wrench.line = entry.node().line();
  return wrench;
}

void readWrenchKey(const Entry& list_item, std::string_view key, WrenchDef& wrench) {
  const Entry entry = list_item.as(list_item.key());
  const std::vector<Key<WrenchDef>>& keys = wrenchKeys();
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.name == key; });
  found->read(entry.child(*entry.node().find(key)), wrench);
}

}  // namespace rigid_body_sim
