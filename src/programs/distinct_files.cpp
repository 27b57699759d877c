#include "programs/distinct_files.hpp"

#include <filesystem>
#include <optional>
#include <tuple>

#include <sys/stat.h>
#include <unistd.h>

#include "programs/usage.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// What tells files apart: device and inode; of one that does not exist yet, the path.
using Identity = std::tuple<dev_t, ino_t, std::string>;

std::optional<Identity> identityOf(const struct stat& status) {
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return std::nullopt;
  return Identity(status.st_dev, status.st_ino, "");
}

std::optional<Identity> identityOf(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) return identityOf(status);
  std::error_code fault;  // whoever opens the file will name it
  namespace fs = std::filesystem;
  // a relative path of which no part exists would stay relative
  const fs::path full = fs::weakly_canonical(fs::absolute(path, fault), fault);
  return fault ? std::nullopt : std::optional(Identity(0, 0, full.string()));
}

std::optional<Identity> identityOf(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 ? identityOf(status) : std::nullopt;
}

}  // namespace

void requireDistinct(const std::vector<NamedFile>& files) {
  struct Known {
    std::string what;
    bool is_written;
    Identity identity;
  };
  std::vector<Known> known;
  if (const auto identity = identityOf(STDOUT_FILENO))
    known.push_back({"standard output", true, *identity});
  if (const auto identity = identityOf(STDERR_FILENO))
    known.push_back({"standard error", true, *identity});
  for (const NamedFile& file : files) {
    const auto identity = identityOf(file.path);
    if (!identity) continue;
    for (const Known& other : known)
      if (other.identity == *identity && (other.is_written || file.is_written))
        throw UsageError(file.what + " and " + other.what + " are the same file, " +
                         oneLine(file.path) + ": name another one for the output");
    known.push_back({file.what, file.is_written, *identity});
  }
}

std::vector<NamedFile> filesOfScene(const std::string& scene,
                                    const std::vector<std::string>& files) {
  std::vector<NamedFile> read{{"the scene", scene, false}};
  for (const std::string& path : files)
    read.push_back({"a file that the scene names", path, false});
  return read;
}

}  // namespace rigid_body_sim
