#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace rigid_body_sim {

/// A file that cannot be written; what() is one line, at whose end there is room for what to do.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws it for what errno says.
[[noreturn]] void failToWrite(const std::string& path);

/// A file that is open for appending, and that no other process may open so meanwhile.
class LockedFile {
 public:
  /// Makes it where it is not there. Throws std::runtime_error where it cannot be written, or is
  /// open in another process, and then leaves it as it was.
  explicit LockedFile(std::string path);
  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&&) = delete;
  ~LockedFile();

  const std::string& path() const { return path_; }

  /// Whether it was not there before.
  bool isNew() const { return is_new_; }

  /// Cuts off what is behind so many bytes. Throws std::runtime_error.
  void cutTo(std::int64_t bytes);

  /// Appends all of a text, or nothing. Throws std::runtime_error where it cannot, or where the
  /// file is not in place.
  void append(const std::string& text);

  /// Throws std::runtime_error where it is no longer the file of its path, so that what is written
  /// would be lost, or has another length than was written.
  void requireInPlace() const;

 private:
  std::string path_;
  int descriptor_ = -1;
  std::uint64_t device_ = 0, inode_ = 0;
  std::int64_t size_ = 0;  // of what was written to its end
  bool is_new_ = false;
};

}  // namespace rigid_body_sim
