#include "programs/formatted.hpp"

#include <cstdarg>
#include <cstdio>

namespace rigid_body_sim {

std::string formatted(const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string line(static_cast<std::size_t>(length), '\0');
  std::vsnprintf(&line[0], line.size() + 1, format, again);
  va_end(again);
  return line;
}

}  // namespace rigid_body_sim
