#include "tools/sweep/locked_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rigid_body_sim {

void failToWrite(const std::string& path) {
  throw WriteError(path + ": cannot be written: " + std::strerror(errno));
}

LockedFile::LockedFile(std::string path) : path_(std::move(path)) {
  constexpr int kFlags = O_WRONLY | O_APPEND | O_CLOEXEC, kMode = 0666;
  descriptor_ = open(path_.c_str(), kFlags | O_CREAT | O_EXCL, kMode);
  is_new_ = descriptor_ >= 0;
  if (!is_new_) descriptor_ = open(path_.c_str(), kFlags | O_CREAT, kMode);
  struct stat file {};
  if (descriptor_ < 0 || fstat(descriptor_, &file) != 0) failToWrite(path_);
  device_ = file.st_dev;
  inode_ = file.st_ino;
  size_ = file.st_size;
  // a file system without locks is taken as it is
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw std::runtime_error(path_ +
                           ": another sweep is writing it; wait for it, or name another --out");
}

LockedFile::LockedFile(LockedFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      device_(other.device_),
      inode_(other.inode_),
      size_(other.size_),
      is_new_(other.is_new_) {}

LockedFile::~LockedFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

void LockedFile::cutTo(std::int64_t bytes) {
  if (ftruncate(descriptor_, bytes) != 0) failToWrite(path_);
  size_ = bytes;
}

void LockedFile::requireInPlace() const {
  struct stat file {};
  if (stat(path_.c_str(), &file) != 0 || file.st_dev != device_ || file.st_ino != inode_)
    throw std::runtime_error(path_ +
                             ": was removed, moved or replaced while this sweep wrote it; put it "
                             "back, and the same command with --resume goes on, or begin anew");
  if (file.st_size != size_)
    throw std::runtime_error(path_ +
                             ": was cut or added to by another program while this sweep wrote it; "
                             "the same command with --resume goes on with what is left of it");
}

void LockedFile::append(const std::string& text) {
  requireInPlace();
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(descriptor_, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int why = errno;
      const bool is_cut = ftruncate(descriptor_, size_) == 0;
      static_cast<void>(is_cut);
      errno = why;
      failToWrite(path_);
    }
    done += static_cast<std::size_t>(n);
  }
  size_ += static_cast<std::int64_t>(text.size());
}

}  // namespace rigid_body_sim
