#include <algorithm>
#include <cmath>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/files/number_text.hpp"
#include "scene/limits.hpp"
#include "scene/readers/entry.hpp"
#include "scene/study/read_record.hpp"
#include "scene/study/study.hpp"

namespace rigid_body_sim {
namespace {

/// A scene refuses what is not finite by its text.
SceneValue::Word numberWord(double x) {
  return {numberText(x), false, std::isfinite(x) ? std::optional<double>(x) : std::nullopt};
}

SceneValue readValue(const Entry& value) {
  using Kind = YamlNode::Kind;
  SceneValue read;
  const auto add = [&](const Entry& entry) {
    if (entry.node().kind() != Kind::kScalar)
      entry.failRule("must be a number, a word or a list of these");
    read.words.push_back(
        {std::string(entry.node().text()), entry.node().quoted(), numberIn(entry.node())});
  };
  read.is_list = value.node().kind() == Kind::kList;
  if (!read.is_list) {
    add(value);
    return read;
  }
  for (const Entry& item : value.items("")) add(item);
  if (read.words.empty()) value.failRule("must not be empty");
  return read;
}

/// At least one value, all of one shape, so that each has its columns.
std::vector<SceneValue> readValues(const Entry& value) {
  const std::string rule = "must be a list of at least one value";
  std::vector<SceneValue> values;
  for (const Entry& item : value.items(rule)) {
    values.push_back(readValue(item));
    const SceneValue &first = values.front(), &last = values.back();
    if (last.is_list != first.is_list || last.words.size() != first.words.size())
      item.failRule("must have as many numbers as the values before it");
  }
  if (values.empty()) value.failRule(rule);
  return values;
}

NormalDistribution readNormal(const Entry& entry) {
  using Def = NormalDistribution;
  static const std::vector<Key<Def>> keys = {
      {"mean", [](const Entry& e, Def& d) { d.mean = readNumber(e, ""); }, true},
      {"stddev", [](const Entry& e, Def& d) { d.stddev = readPositive(e, ""); }, true},
  };
  Def normal;
  readMapping(entry, keys, normal);
  return normal;
}

UniformDistribution readUniform(const Entry& entry) {
  const std::vector<double> ends = readNumbers(entry, 2, "");
  if (!(ends[0] < ends[1])) entry.failRule("must be [low, high] with low < high");
  return {ends[0], ends[1]};
}

RotationDistribution readRotation(const Entry& entry) {
  using Def = RotationDistribution;
  static const std::vector<Key<Def>> keys = {
      {"stddev", [](const Entry& e, Def& d) { d.stddev = readPositive(e, "rad"); }},
  };
  Def rotation;
  readMapping(entry, keys, rotation);
  return rotation;
}

Distribution readDistribution(const Entry& entry) {
  using Def = std::vector<Distribution>;
  static const std::vector<Key<Def>> keys = {
      {"normal", [](const Entry& e, Def& d) { d.emplace_back(readNormal(e)); }},
      {"uniform", [](const Entry& e, Def& d) { d.emplace_back(readUniform(e)); }},
      {"list", [](const Entry& e, Def& d) { d.emplace_back(ListDistribution{readValues(e)}); }},
      {"grid", [](const Entry& e, Def& d) { d.emplace_back(GridDistribution{readValues(e)}); }},
      {"rotation", [](const Entry& e, Def& d) { d.emplace_back(readRotation(e)); }},
  };
  Def found;
  readMapping(entry, keys, found);
  if (found.size() > 1) {
    std::string names;
    for (const YamlNode& node : entry.node().children())
      names += (names.empty() ? "" : " and ") + std::string(node.key());
    entry.fail(entry.key() + " must name exactly one distribution, got " + names);
  }
  if (found.empty()) entry.failRule("must name one of normal, uniform, list, grid and rotation");
  return found.front();
}

std::vector<Varied> readVary(const Entry& entry) {
  if (entry.node().kind() != YamlNode::Kind::kMapping || entry.node().children().empty())
    entry.failRule("must be a mapping of at least one path to what its value may be");
  entry.checkCount(kMaxVariedPaths, "paths");
  std::vector<Varied> vary;
  for (const YamlNode& node : entry.node().children())
    vary.push_back({std::string(node.key()), readDistribution(entry.child(node)), node.line()});
  return vary;
}

std::int64_t readRuns(const Entry& value) {
  return static_cast<std::int64_t>(readWhole(value, 1, kMaxSweepRuns));
}

/// What is divided must not lose its digits.
double readRunDuration(const Entry& value) {
  const double duration = readPositive(value, "s");
  if (duration < 1e-300) value.failRule("must be at least 1e-300 s");
  return duration;
}

void refuseManyRuns(const Study& study, const Entry& root) {
  const std::int64_t cells = gridSize(study);
  if (cells <= kMaxSweepRuns / study.runs) return;
  root.child(*root.node().find("vary"))
      .fail("runs times the values of the grids must be at most " + std::to_string(kMaxSweepRuns) +
            ", got " + std::to_string(study.runs) + " times " +
            (cells > kMaxSweepRuns ? "more than that" : std::to_string(cells)));
}

}  // namespace

SceneValue SceneValue::of(double x) { return {{numberWord(x)}, false}; }

SceneValue SceneValue::of(const std::vector<double>& list) {
  SceneValue value;
  value.is_list = true;
  for (const double x : list) value.words.push_back(numberWord(x));
  return value;
}

bool SceneValue::operator==(const SceneValue& other) const {
  return is_list == other.is_list &&
         std::equal(words.begin(), words.end(), other.words.begin(), other.words.end(),
                    [](const Word& a, const Word& b) { return a.text == b.text; });
}

std::int64_t gridSize(const Study& study) {
  std::int64_t cells = 1;
  for (const Varied& varied : study.vary)
    if (const auto* grid = std::get_if<GridDistribution>(&varied.distribution))
      cells = std::min(cells * static_cast<std::int64_t>(grid->values.size()), kMaxSweepRuns + 1);
  return cells;
}

Study parseStudy(const std::string& yaml_text, const std::string& source_name,
                 std::optional<std::int64_t> runs, std::optional<std::uint64_t> seed) {
  static const std::vector<Key<Study>> keys = {
      {"runs", [](const Entry& e, Study& s) { s.runs = readRuns(e); }},
      {"seed", [](const Entry& e, Study& s) { s.seed = readWhole(e); }},
      {"latin_hypercube", [](const Entry& e, Study& s) { s.latin_hypercube = readBoolean(e); }},
      {"duration", [](const Entry& e, Study& s) { s.duration = readRunDuration(e); }},
      {"vary", [](const Entry& e, Study& s) { s.vary = readVary(e); }, true},
      {"record", [](const Entry& e, Study& s) { s.record = readRecords(e); }},
  };
  const YamlDocument document = parseYaml(yaml_text, source_name);
  ReadContext context;
  context.source = source_name;
  const Entry root(context, document.root);
  if (document.root.find("bodies"))
    root.fail("is a scene, not a study: the scene comes first, the study second");
  Study study;
  study.source = source_name;
  readMapping(root, keys, study);
  study.runs = runs.value_or(study.runs);
  study.seed = seed.value_or(study.seed);
  if (study.runs == 0) root.fail("missing key 'runs'");
  refuseManyRuns(study, root);
  return study;
}

}  // namespace rigid_body_sim
