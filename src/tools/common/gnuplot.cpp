#include "tools/common/gnuplot.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <future>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "programs/usage.hpp"
#include "scene/files/write_file.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {

bool hasGnuplot() { return std::system("command -v gnuplot >/dev/null 2>&1") == 0; }

std::string gnuplotIsMissing(const std::string& there) {
  return "gnuplot is not installed: " + there + ", the plot is not (apt install gnuplot-nox)";
}

std::string pictureDirectory(const std::string& what, const std::string& path) {
  if (oneLine(path) != path)
    throw UsageError(what + ": must be a path without control characters, got '" + printable(path) +
                     "'");
  return path;
}

namespace {

bool isWhole(const std::string& picture) {
  constexpr std::size_t kTail = 16;
  return picture.find("</svg>", picture.size() - std::min(picture.size(), kTail)) !=
         std::string::npos;
}

/// Two ends of a pipe, of which a child sees none unless it opens one by its path.
class PicturePipe {
 public:
  PicturePipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw std::runtime_error(std::string("no pipe for a picture: ") + std::strerror(errno));
  }
  PicturePipe(const PicturePipe&) = delete;
  PicturePipe& operator=(const PicturePipe&) = delete;
  ~PicturePipe() {
    close(ends_[0]);
    closeInput();
  }

  std::string inputPath() const {
    return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(ends_[1]);
  }
  void closeInput() {
    if (ends_[1] >= 0) close(std::exchange(ends_[1], -1));
  }
  /// What comes until its input is closed everywhere.
  std::string readAll() const {
    std::string text;
    std::array<char, 1 << 16> block{};
    for (ssize_t n = 0; (n = read(ends_[0], block.data(), block.size())) != 0;) {
      if (n < 0 && errno != EINTR) break;  // then it is not whole
      text.append(block.data(), static_cast<std::size_t>(std::max<ssize_t>(0, n)));
    }
    return text;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Lets gnuplot draw to a file.
void draw(const std::string& script, const std::string& to, const std::string& name) {
  // its warnings are about its script, which the user has not written
  std::FILE* gnuplot = popen(("gnuplot 2>/dev/null >" + to).c_str(), "w");
  if (!gnuplot) throw std::runtime_error("gnuplot cannot be started");
  std::fputs(script.c_str(), gnuplot);
  if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot could not draw " + name);
}

}  // namespace

std::string drawnByGnuplot(const std::string& script, const std::string& name) {
  PicturePipe pipe;
  // beside the script: neither end waits for the other
  std::future<std::string> drawn = std::async(std::launch::async, [&] { return pipe.readAll(); });
  try {
    draw(script, pipe.inputPath(), name);
  } catch (...) {
    pipe.closeInput();
    throw;
  }
  pipe.closeInput();
  std::string picture = drawn.get();
  if (!isWhole(picture)) throw std::runtime_error("gnuplot could not draw the end of " + name);
  return picture;
}

void drawByGnuplot(const std::string& script, const std::string& picture) {
  std::error_code fault = writeFault(picture);
  if (!fault) fault = writeFile(picture, drawnByGnuplot(script, oneLine(picture)));
  if (fault) throw std::runtime_error(oneLine(picture) + ": cannot be written: " + fault.message());
}

std::string gnuplotText(const std::string& text) {
  std::string doubled;
  for (char c : text) doubled += c == '\'' ? "''" : std::string(1, c);
  return "'" + doubled + "'";
}

}  // namespace rigid_body_sim
