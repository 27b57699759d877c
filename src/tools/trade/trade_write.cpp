#include "tools/trade/trade_write.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"
#include "programs/tool_scene.hpp"

namespace rigid_body_sim {
namespace {

constexpr const char* kBlanks = " \t";

/// Lines with their ends.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  return lines;
}

/// Where a line that begins with `key:` has its value; npos for any other line.
std::size_t valueAt(const std::string& line, const std::string& key) {
  if (line.compare(0, key.size(), key) != 0) return std::string::npos;
  const std::size_t colon = line.find_first_not_of(kBlanks, key.size());
  if (colon == std::string::npos || line[colon] != ':') return std::string::npos;
  return line.find_first_not_of(kBlanks, colon + 1);
}

/// The lines of a scene file, whose keys of the top level can be changed.
class EditedScene {
 public:
  explicit EditedScene(const std::string& text) : lines_(linesOf(text)) {}

  bool has(const std::string& key) const { return find(key) != lines_.size(); }

  /// Puts a value in place of the key's own; a comment behind it stays.
  void replace(const std::string& key, const std::string& value) {
    std::string& line = lines_.at(find(key));
    const std::size_t begin = valueAt(line, key);
    const std::size_t comment = std::min(line.find(" #", begin), line.size());
    const std::size_t end = line.find_last_not_of(" \t\r\n", comment - 1) + 1;
    line.replace(begin, end - begin, value);
  }

  void insertAfter(const std::string& key, const std::string& line) {
    std::string& before = lines_.at(find(key));
    const std::string end = before.size() > 1 && before[before.size() - 2] == '\r' ? "\r\n" : "\n";
    if (before.back() != '\n') before += end;
    lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(find(key)) + 1, line + end);
  }

  void commentOut(const std::string& key) { lines_.at(find(key)).insert(0, "# "); }

  std::string text() const {
    std::string all;
    for (const std::string& line : lines_) all += line;
    return all;
  }

 private:
  std::size_t find(const std::string& key) const {
    const auto is_of_key = [&](const std::string& line) {
      return valueAt(line, key) != std::string::npos;
    };
    return static_cast<std::size_t>(std::find_if(lines_.begin(), lines_.end(), is_of_key) -
                                    lines_.begin());
  }

  std::vector<std::string> lines_;
};

std::string edited(const std::string& text, const std::string& integrator, double time_step,
                   double tolerance) {
  EditedScene scene(text);
  scene.replace("time_step", shortest(time_step));
  if (scene.has("integrator"))
    scene.replace("integrator", integrator);
  else if (integrator != "auto")
    scene.insertAfter("time_step", "integrator: " + integrator);
  if (integrator != "auto" && scene.has("tolerance")) scene.commentOut("tolerance");
  if (tolerance > 0 && scene.has("tolerance"))
    scene.replace("tolerance", shortest(tolerance));
  else if (tolerance > 0)
    scene.insertAfter("time_step", "tolerance: " + shortest(tolerance));
  return scene.text();
}

/// A file beside another, removed unless it has taken the other's place.
class Replacement {
 public:
  Replacement(const std::string& path, const std::string& text) : path_(path) {
    struct stat status {};
    const int file = mkstemp(&name_[0]);
    const bool written = file >= 0 && stat(path.c_str(), &status) == 0 &&
                         fchmod(file, status.st_mode) == 0 &&
                         write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const int reason = errno;
    if (file >= 0) close(file);
    if (written) return;
    std::remove(name_.c_str());
    throw std::runtime_error(path + ": cannot be written: " + std::strerror(reason));
  }
  ~Replacement() { std::remove(name_.c_str()); }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  const std::string& name() const { return name_; }

  void take() {
    if (std::rename(name_.c_str(), path_.c_str()) != 0)
      throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
  }

 private:
  std::string path_;
  std::string name_ = path_ + ".XXXXXX";
};

/// Whether a scene file says the integrator, the step and, where it is not 0, the tolerance.
bool says(const std::string& path, const std::string& integrator, double time_step,
          double tolerance) {
  try {
    const Scene scene = loadToolScene(path);
    return scene.integrator == integrator && scene.time_step == time_step &&
           (tolerance == 0 || scene.tolerance == tolerance);
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

std::string writeSolver(const std::string& path, const std::string& integrator, double time_step,
                        double tolerance) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  try {
    const std::string target = std::filesystem::canonical(path).string();  // not a link to it
    Replacement replacement(target, edited(text.str(), integrator, time_step, tolerance));
    if (!says(replacement.name(), integrator, time_step, tolerance)) throw std::out_of_range("");
    replacement.take();
  } catch (const std::out_of_range&) {
    throw std::runtime_error(path +
                             ": its keys do not stand on lines of their own: left as it was; "
                             "replace integrator and time_step by hand");
  }
  return path + ": now integrator " + integrator + ", time_step " + shortest(time_step) +
         (tolerance > 0 ? ", tolerance " + shortest(tolerance) : "");
}

}  // namespace rigid_body_sim
