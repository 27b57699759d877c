#include "scene/files/percent_code.hpp"

namespace rigid_body_sim {
namespace {

constexpr char kDigits[] = "0123456789ABCDEF";

bool isPlain(char c) { return c >= ' ' && c <= '~' && c != '%' && c != '"' && c != '\\'; }

/// -1 for what is no digit.
int valueOf(char digit) {
  for (int value = 0; value < 16; ++value)
    if (kDigits[value] == digit) return value;
  return -1;
}

}  // namespace

std::string percentEncoded(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    if (isPlain(c)) {
      text += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    text += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
  }
  return text;
}

std::optional<std::string> percentDecoded(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      bytes += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = valueOf(text[i + 1]), low = valueOf(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    bytes += static_cast<char>(16 * high + low);
    i += 2;
  }
  return bytes;
}

}  // namespace rigid_body_sim
