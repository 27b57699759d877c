#pragma once

#include <string>
#include <vector>

namespace rigid_body_sim {

/// A file that a command line names.
struct NamedFile {
  std::string what;  ///< for the message, such as "--csv"
  std::string path;
  bool is_written = false;
};

/// Throws UsageError where a file that is written is named twice, by whatever path, or is one of
/// those that are read, or where standard output or error goes. Devices are no files: two outputs
/// may both go to /dev/null.
void requireDistinct(const std::vector<NamedFile>& files);

/// What is read of a scene: its file, and those that it names (see Scene).
std::vector<NamedFile> filesOfScene(const std::string& scene,
                                    const std::vector<std::string>& files);

}  // namespace rigid_body_sim
