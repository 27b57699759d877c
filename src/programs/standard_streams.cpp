#include "programs/standard_streams.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

#include "programs/usage.hpp"

namespace rigid_body_sim {

void reserveStandardStreams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // the other way round than the stream is used: its use fails, as it does on a closed one
    const int flags = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (open("/dev/null", flags) == descriptor) continue;
    std::perror("/dev/null");
    std::exit(kBadInput);
  }
}

void failBeyondFileSize() { std::signal(SIGXFSZ, SIG_IGN); }

bool isOpen(std::FILE* stream) { return (fcntl(fileno(stream), F_GETFL) & O_ACCMODE) != O_RDONLY; }

void requireWritten(std::FILE* stream, const std::string& name) {
  if (std::fflush(stream) != 0 || std::ferror(stream) != 0)
    throw std::runtime_error(name + " cannot be written: " + std::strerror(errno));
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  requireWritten(stdout);
}

}  // namespace rigid_body_sim
