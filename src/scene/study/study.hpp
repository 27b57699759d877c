#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rigid_body_sim {

/// What a study file of `sweep` says. `line` is where an entry stands in the file.

/// A value as a scene file may hold it: a word, or a list of words.
struct SceneValue {
  struct Word {
    std::string text;
    bool quoted = false;
    std::optional<double> number{};  ///< that the text is, where it was found already
  };
  std::vector<Word> words;
  bool is_list = false;

  /// Of a number, and of a list of numbers.
  static SceneValue of(double x);
  static SceneValue of(const std::vector<double>& list);

  bool operator==(const SceneValue& other) const;
};

/// Gaussian.
struct NormalDistribution {
  double mean = 0;
  double stddev = 0;  ///< > 0
};

/// Uniform over [low, high).
struct UniformDistribution {
  double low = 0, high = 0;  ///< low < high
};

/// One of the values, each as likely as the others.
struct ListDistribution {
  std::vector<SceneValue> values;
};

/// Each of the values with every other choice of the grids: multiplies the runs.
struct GridDistribution {
  std::vector<SceneValue> values;
};

/// An attitude: uniform over all of them, or the scene's own turned by a rotation vector whose
/// components are normal with this standard deviation [rad].
struct RotationDistribution {
  std::optional<double> stddev;  ///< > 0
};

using Distribution = std::variant<NormalDistribution, UniformDistribution, ListDistribution,
                                  GridDistribution, RotationDistribution>;

/// A path into the scene file, such as bodies.box.twist.angular[2], and what its value may be.
struct Varied {
  std::string path;
  Distribution distribution;
  int line = 0;
};

/// What is looked at of a body: a column of simulate's CSV, or a norm: "v" [m/s] or "w" [rad/s].
struct QuantityDef {
  std::string body;
  std::string name;  ///< such as "pz"
};

enum class Reduction { kMax, kMin, kAtEnd, kFirst };

/// A column of the results: the greatest or least value of a quantity over the run, its value at
/// the end, or the first instant [s] at which it is below or above a level.
struct RecordDef {
  std::string name;
  Reduction reduction = Reduction::kAtEnd;
  QuantityDef quantity;
  bool below = false;  ///< with kFirst
  double level = 0;    ///< with kFirst
  int line = 0;
};

struct Study {
  std::string source;     ///< file name, for messages
  std::int64_t runs = 0;  ///< > 0, without the grids
  std::uint64_t seed = 0;
  bool latin_hypercube = false;    ///< normal, uniform, list and rotation are stratified
  std::optional<double> duration;  ///< [s] none: the scene's horizon
  std::vector<Varied> vary;
  std::vector<RecordDef> record;
};

/// Runs that a study may ask for, the grids counted in.
constexpr std::int64_t kMaxSweepRuns = 100000000;

/// How many choices the grids of a study have together, at most kMaxSweepRuns + 1.
std::int64_t gridSize(const Study& study);

/// Reads the text of a study file. An unknown or missing key, an empty list, a value that breaks
/// its rule and more than kMaxSweepRuns runs throw SceneError, one line. runs, seed: of the command
/// line, in place of the file's.
Study parseStudy(const std::string& yaml_text, const std::string& source_name,
                 std::optional<std::int64_t> runs = {}, std::optional<std::uint64_t> seed = {});

}  // namespace rigid_body_sim
