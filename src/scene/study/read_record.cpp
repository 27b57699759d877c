#include "scene/study/read_record.hpp"

#include <algorithm>

#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

/// "box.pz"
QuantityDef quantityIn(const Entry& value, std::string_view text) {
  const std::size_t dot = text.rfind('.');
  const std::string rule = "must be a body and a quantity, such as box.pz";
  if (dot == std::string_view::npos || dot == 0) value.failRule(rule);
  QuantityDef quantity{std::string(text.substr(0, dot)), std::string(text.substr(dot + 1))};
  const std::vector<std::string>& names = quantityNames();
  if (std::find(names.begin(), names.end(), quantity.name) == names.end())
    value.fail((value.key().empty() ? "" : value.key() + ": ") + "unknown quantity '" +
               printable(quantity.name) + "' (known: " + nameList(names, names.size()) + ")" +
               didYouMean(quantity.name, names));
  return quantity;
}

QuantityDef readQuantity(const Entry& value) { return quantityIn(value, readText(value)); }

/// {box.pz: {below: 0}}
void readFirst(const Entry& entry, RecordDef& record) {
  static const std::vector<Key<RecordDef>> keys = {
      {"below",
       [](const Entry& e, RecordDef& r) {
         r.below = true;
         r.level = readNumber(e, "");
       }},
      {"above", [](const Entry& e, RecordDef& r) { r.level = readNumber(e, ""); }},
  };
  record.reduction = Reduction::kFirst;
  if (entry.node().kind() != YamlNode::Kind::kMapping || entry.node().children().size() != 1)
    entry.failRule("must be one quantity with a level, such as {box.pz: {below: 0}}");
  const Entry level = entry.child(entry.node().children().front());
  record.quantity = quantityIn(level, level.node().key());
  readMapping(level, keys, record);
  if (level.node().children().size() != 1) level.failRule("must name one of below and above");
}

RecordDef readRecord(const Entry& entry) {
  static const auto reduced = [](Reduction reduction, const Entry& e, RecordDef& r) {
    r.reduction = reduction;
    r.quantity = readQuantity(e);
  };
  static const std::vector<Key<RecordDef>> keys = {
      {"max", [](const Entry& e, RecordDef& r) { reduced(Reduction::kMax, e, r); }},
      {"min", [](const Entry& e, RecordDef& r) { reduced(Reduction::kMin, e, r); }},
      {"at_end", [](const Entry& e, RecordDef& r) { reduced(Reduction::kAtEnd, e, r); }},
      {"first", [](const Entry& e, RecordDef& r) { readFirst(e, r); }},
  };
  RecordDef record;
  record.name = std::string(entry.node().key());
  record.line = entry.node().line();
  if (!isName(record.name)) entry.fail("record: '" + printable(record.name) + "' " + nameRule());
  readMapping(entry, keys, record);
  if (entry.node().children().size() != 1)
    entry.failRule("must name one of max, min, at_end and first");
  return record;
}

}  // namespace

std::vector<RecordDef> readRecords(const Entry& entry) {
  if (entry.node().kind() != YamlNode::Kind::kMapping)
    entry.failRule("must be a mapping of names to what is recorded");
  entry.checkCount(kMaxRecords, "records");
  static const std::vector<std::string> taken = {"run", "attitude_error", "position_error",
                                                 "status"};
  std::vector<RecordDef> records;
  for (const YamlNode& node : entry.node().children()) {
    const Entry record = entry.child(node);
    if (std::find(taken.begin(), taken.end(), node.key()) != taken.end())
      record.fail("record: '" + std::string(node.key()) + "' is a column that every sweep has");
    records.push_back(readRecord(record));
  }
  return records;
}

const std::vector<std::string>& quantityNames() {
  static const std::vector<std::string> names = {"px", "py", "pz", "qx", "qy", "qz", "qw", "vx",
                                                 "vy", "vz", "wx", "wy", "wz", "v",  "w"};
  return names;
}

}  // namespace rigid_body_sim
