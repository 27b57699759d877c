#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include <rigid_body_sim/math/rotation.hpp>

#include "scene/files/number_text.hpp"
#include "scene/limits.hpp"
#include "scene/readers/entry.hpp"

namespace rigid_body_sim {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// Whether the text is a decimal number: [-+]?(d+(.d*)?|.d+)([eE][-+]?d+)?
bool isDecimal(std::string_view text) {
  std::size_t i = 0;
  const auto skipSign = [&] { i += i < text.size() && (text[i] == '+' || text[i] == '-'); };
  const auto skipDigits = [&] {
    const std::size_t first = i;
    while (i < text.size() && isDigit(text[i])) ++i;
    return i - first;
  };
  skipSign();
  std::size_t digits = skipDigits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    digits += skipDigits();
  }
  if (digits == 0) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    skipSign();
    if (skipDigits() == 0) return false;
  }
  return i == text.size();
}

}  // namespace

std::optional<double> numberIn(const YamlNode& node) {
  if (node.kind() != YamlNode::Kind::kScalar || node.quoted()) return std::nullopt;
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const bool negative = !node.text().empty() && node.text()[0] == '-';
  const bool has_sign = negative || (!node.text().empty() && node.text()[0] == '+');
  const std::string_view magnitude = node.text().substr(has_sign ? 1 : 0);
  if (magnitude == ".inf" || magnitude == ".Inf" || magnitude == ".INF")
    return negative ? -kInf : kInf;
  if (node.text() == ".nan" || node.text() == ".NaN" || node.text() == ".NAN")
    return std::numeric_limits<double>::quiet_NaN();
  if (!isDecimal(node.text())) return std::nullopt;

  // infinite where it does not fit into a double
  double number = 0;
  readNumberText(node.text().data(), node.text().data() + node.text().size(), number);
  return number;
}

namespace {

/// As in URDF: about the fixed axes, roll about x first, then pitch about y, then yaw about z.
Quaterniond readRollPitchYaw(const Entry& value) {
  static const std::vector<Key<Vector3d>> keys = {
      {"rpy", [](const Entry& e, Vector3d& v) { v = readVector3(e, "rad"); }, true},
  };
  Vector3d rpy = Vector3d::Zero();
  readMapping(value, keys, rpy);
  return Eigen::AngleAxisd(rpy[2], Vector3d::UnitZ()) *
         Eigen::AngleAxisd(rpy[1], Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy[0], Vector3d::UnitX());
}

std::string bracketed(const std::string& unit) { return unit.empty() ? "" : " [" + unit + "]"; }

}  // namespace

bool readBoolean(const Entry& value) {
  const YamlNode& node = value.node();
  const bool plain = node.kind() == YamlNode::Kind::kScalar && !node.quoted();
  if (plain && node.text() == "true") return true;
  if (plain && node.text() == "false") return false;
  value.failRule("must be true or false");
}

std::string readText(const Entry& value) {
  if (value.node().kind() != YamlNode::Kind::kScalar || value.node().text().empty())
    value.failRule("must be a text");
  return std::string(value.node().text());
}

std::string readTextOrNone(const Entry& value) {
  const YamlNode& node = value.node();
  const bool none = node.kind() == YamlNode::Kind::kScalar && node.text().empty();
  return none ? std::string() : readText(value);
}

bool isName(std::string_view text) {
  if (text.empty() || text.size() > kMaxNameBytes || !isLetter(text[0])) return false;
  for (const char c : text) {
    if (!isLetter(c) && !isDigit(c) && c != '_') return false;
  }
  return true;
}

std::string nameRule() {
  return "must be a name [A-Za-z][A-Za-z0-9_]* of at most " + std::to_string(kMaxNameBytes) +
         " bytes";
}

std::string readName(const Entry& value) {
  if (value.node().kind() != YamlNode::Kind::kScalar || !isName(value.node().text()))
    value.failRule(nameRule());
  return std::string(value.node().text());
}

bool isFrameName(std::string_view text) {
  if (text.empty() || text.size() > kMaxNameBytes || text.front() == '/' || text.back() == '/')
    return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool in_part = isLetter(c) || isDigit(c) || c == '_' || c == '-' || c == '.';
    if (!in_part && !(c == '/' && text[i - 1] != '/')) return false;
  }
  return true;
}

std::string frameNameRule() {
  return "must be a frame name: letters, digits, _, - and ., parts joined by /, at most " +
         std::to_string(kMaxNameBytes) + " bytes";
}

std::string readFrameName(const Entry& value) {
  if (value.node().kind() != YamlNode::Kind::kScalar || !isFrameName(value.node().text()))
    value.failRule(frameNameRule());
  return std::string(value.node().text());
}

double readNumber(const Entry& value, const std::string& unit) {
  const std::optional<double> number = numberIn(value.node());
  if (!number) value.failRule("must be a number" + bracketed(unit));
  if (!std::isfinite(*number)) value.failRule("must be a finite number" + bracketed(unit));
  return *number;
}

std::uint64_t readWhole(const Entry& value, std::uint64_t least, std::uint64_t most) {
  const std::string_view text = value.node().text();
  const char* const end = text.data() + text.size();
  std::uint64_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const bool plain = value.node().kind() == YamlNode::Kind::kScalar && !value.node().quoted();
  if (!plain || text.empty() || rest != end || error != std::errc() || number < least ||
      number > most)
    value.failRule(
        "must be a whole number from " + std::to_string(least) + " to " +
        (most == std::numeric_limits<std::uint64_t>::max() ? "2^64 - 1" : std::to_string(most)));
  return number;
}

double readBound(const Entry& value, const std::string& unit) {
  const std::optional<double> number = numberIn(value.node());
  if (!number || std::isnan(*number))
    value.failRule("must be a number, -.inf or .inf" + bracketed(unit));
  return *number;
}

double readPositive(const Entry& value, const std::string& unit) {
  const double number = readNumber(value, unit);
  if (!(number > 0)) value.failRule("must be > 0" + (unit.empty() ? "" : " " + unit));
  return number;
}

double readNotNegative(const Entry& value, const std::string& unit) {
  const double number = readNumber(value, unit);
  if (!(number >= 0)) value.failRule("must be >= 0" + (unit.empty() ? "" : " " + unit));
  return number;
}

double readDuration(const Entry& value) {
  const std::optional<double> number = numberIn(value.node());
  if (!number) value.failRule("must be a number [s]");
  if (!(*number > 0)) value.failRule("must be > 0 s");
  return *number;
}

std::vector<double> readNumbers(const Entry& value, std::size_t count, const std::string& unit) {
  // the rule is put together only when it is broken: a sweep reads values a million times
  if (value.node().kind() != YamlNode::Kind::kList || value.node().children().size() != count)
    value.failRule("must be a list of " + std::to_string(count) + " numbers" + bracketed(unit));
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(readNumber(value.item(i), unit));
  return numbers;
}

Vector3d readVector3(const Entry& value, const std::string& unit) {
  const std::vector<double> v = readNumbers(value, 3, unit);
  return {v[0], v[1], v[2]};
}

Quaterniond readOrientation(const Entry& value) {
  if (value.node().kind() == YamlNode::Kind::kMapping) return readRollPitchYaw(value);
  const std::vector<double> q = readNumbers(value, 4, "");
  const Quaterniond quaternion(q[3], q[0], q[1], q[2]);
  if (!isNearlyUnit(quaternion)) {
    std::ostringstream norm;
    norm << quaternion.norm();
    value.fail(value.key() +
               " must be a unit quaternion [x, y, z, w], its norm within 1e-3 of 1, got " +
               printable(value.node()) + " of norm " + norm.str());
  }
  return quaternion.normalized();
}

}  // namespace rigid_body_sim
