#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/readers/read_context.hpp"
#include "scene/readers/yaml_tree.hpp"
#include "scene/study/plain_number.hpp"
#include "scene/study/study.hpp"

namespace rigid_body_sim {

/// A scene file that is read once, and whose values at given paths are then replaced in memory: of
/// the scene only the entries that hold them are read anew, by the readers of the file, so that
/// every rule holds and every message is theirs.
class VariedScene {
 public:
  /// text: of the scene file; context: as loadScene makes it. Throws SceneError for a scene or a
  /// path at fault, and names the path that differs least where one does not exist.
  VariedScene(const std::string& text, ReadContext context, const Study& study);
  VariedScene(const VariedScene&) = delete;
  VariedScene& operator=(const VariedScene&) = delete;

  /// The value at the path number `index` of the study, as the file has it; none: it has not.
  const SceneValue& own(std::size_t index) const { return slots_[index].own; }

  /// What it is at present.
  const SceneValue& now(std::size_t index) const { return slots_[index].now; }

  /// Replaces it.
  void set(std::size_t index, const SceneValue& value);
  void set(std::size_t index, double x);

  /// The scene with the values that are set. Throws SceneError for a value that breaks its rule.
  const Scene& scene();

  /// The same as it was last read.
  const Scene& read() const { return scene_; }

  /// Of which body the value is, as an index; kNoBody: of none.
  static constexpr std::size_t kNoBody = static_cast<std::size_t>(-1);
  std::size_t bodyOf(std::size_t index) const {
    return slots_[index].part == Part::kBody ? slots_[index].entry : kNoBody;
  }

  /// The scene file with the values that are set, without its comments; paths of files are made
  /// absolute.
  std::string yaml() const;

  const ReadContext& context() const { return context_; }

 private:
  /// What has to be read anew where a value changes.
  enum class Part { kWhole, kBody, kForce, kWrench, kCommand };

  struct Slot {
    std::string path;
    Part part = Part::kWhole;
    std::size_t entry = 0;  ///< index in its list
    std::string key;        ///< where it can be read by itself, else empty
    std::optional<PlainNumber> plain{};
    YamlNode* node = nullptr;
    SceneValue own, now;
    bool is_read = true;
  };

  void addDefaults(const Study& study);
  void addSlot(const Varied& varied, const Study& study);
  void refuseOverlaps(const Study& study) const;
  void findPart(Slot& slot);
  void placeNow(Slot& slot);
  bool setPlain(const Slot& slot);
  bool isReadBefore(std::size_t index) const;
  void readEntry(const Slot& slot);

  YamlDocument document_;
  ReadContext context_;
  Scene scene_;
  bool defaults_added_ = false;
  std::vector<Slot> slots_;
};

}  // namespace rigid_body_sim
