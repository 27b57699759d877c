#include "tools/simulate/csv_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace rigid_body_sim {

CsvFile::CsvFile(const std::string& path, const char* header)
    : path_(path), file_(path == "-" ? stdout : std::fopen(path.c_str(), "w")) {
  if (!file_) fail();
  std::fprintf(file_, "%s\n", header);
}

CsvFile::~CsvFile() {
  if (file_ != stdout) std::fclose(file_);
}

void CsvFile::check() const {
  if (std::ferror(file_)) fail();
}

void CsvFile::finish() {
  if (std::fflush(file_) != 0 || std::ferror(file_)) fail();
}

void CsvFile::fail() const {
  throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace rigid_body_sim
