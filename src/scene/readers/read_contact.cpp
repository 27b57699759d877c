#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

/// What an entry says of contact; the dissipation may be said in two ways.
struct ContactEntry {
  ContactDef contact;
  ContactParameters& parameters() { return contact.parameters; }
  bool has_dissipation = false;
  double restitution = 0;     // 0: not given
  double approach_speed = 0;  // [m/s] likewise
};

/// Two names; `all` in place of the second stands for every other body.
void readBetween(const Entry& value, ContactDef& contact) {
  const std::string rule = "must be [body, body] or [body, all]";
  const std::vector<Entry> names = value.items(rule);
  if (names.size() != 2) value.failRule(rule);
  contact.body = readText(names[0]);
  contact.other = readText(names[1]);
  if (contact.body == contact.other || contact.body == "all")
    value.failRule("must be [body, body] or [body, all], of two bodies");
  if (contact.other == "all") contact.other.clear();
}

double readRestitution(const Entry& value) {
  const double e = readNumber(value, "");
  if (!(e > 0 && e <= 1))
    value.failRule("must be > 0 and <= 1 (0 would need an infinite dissipation; 0.01 comes near)");
  return e;
}

double readExponent(const Entry& value) {
  const double p = readNumber(value, "");
  if (!(p >= 1)) value.failRule("must be >= 1");
  return p;
}

/// Of the two ways to say how much an impact dissipates one may be used, and as a whole.
void checkDissipation(const Entry& mapping, const ContactEntry& read) {
  const YamlNode* restitution = mapping.node().find("restitution");
  const YamlNode* at = mapping.node().find("at");
  if (restitution && read.has_dissipation)
    mapping.child(*restitution).failRule("cannot stand beside dissipation, which it determines");
  if (restitution && !at)
    mapping.child(*restitution)
        .failRule("needs at: the speed of approach [m/s] at which it is returned");
  if (at && !restitution) mapping.child(*at).failRule("goes with restitution");
}

}  // namespace

ContactDef readContact(const Entry& entry) {
  static const std::vector<Key<ContactEntry>> keys = {
      {"type", [](const Entry&, ContactEntry&) {}, true},
      {"between", [](const Entry& e, ContactEntry& c) { readBetween(e, c.contact); }, true},
      {"stiffness",
       [](const Entry& e, ContactEntry& c) {
         c.parameters().stiffness = readPositive(e, "N/m^exponent");
       },
       true},
      {"exponent",
       [](const Entry& e, ContactEntry& c) { c.parameters().exponent = readExponent(e); }},
      {"dissipation",
       [](const Entry& e, ContactEntry& c) {
         c.parameters().dissipation = readNotNegative(e, "s/m");
         c.has_dissipation = true;
       }},
      {"restitution", [](const Entry& e, ContactEntry& c) { c.restitution = readRestitution(e); }},
      {"at", [](const Entry& e, ContactEntry& c) { c.approach_speed = readPositive(e, "m/s"); }},
      {"friction",
       [](const Entry& e, ContactEntry& c) { c.parameters().friction = readNotNegative(e, ""); }},
      {"breakaway",
       [](const Entry& e, ContactEntry& c) { c.parameters().breakaway = readPositive(e, "m"); }},
      {"rolling_friction",
       [](const Entry& e, ContactEntry& c) {
         c.parameters().rolling_friction = readNotNegative(e, "m");
       }},
  };
  ContactEntry read;
  readMapping(entry, keys, read);
  checkDissipation(entry, read);
  if (read.restitution > 0)
    read.parameters().dissipation =
        dissipationForRestitution(read.restitution, read.approach_speed);
  return read.contact;
}

}  // namespace rigid_body_sim
