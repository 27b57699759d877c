#include "tools/simulate/csv_writer.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "tools/common/csv_header.hpp"

namespace rigid_body_sim {

CsvWriter::CsvWriter(const std::string& path)
    : path_(path), file_(path == "-" ? stdout : std::fopen(path.c_str(), "w")) {
  if (!file_) fail();
  std::fprintf(file_, "%s\n", kCsvHeader);
}

CsvWriter::~CsvWriter() {
  if (file_ != stdout) std::fclose(file_);
}

void CsvWriter::write(const World& world, const State& state) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    const BodyFrameMotion m = toBodyFrameMotion(body, state.bodies[i]);
    std::fprintf(file_, "%.17g,%s", state.t, body.name.c_str());
    for (double x : {m.x_W.x(), m.x_W.y(), m.x_W.z(), m.q_WB.x(), m.q_WB.y(), m.q_WB.z(),
                     m.q_WB.w(), m.v_W.x(), m.v_W.y(), m.v_W.z(), m.w_W.x(), m.w_W.y(), m.w_W.z()})
      std::fprintf(file_, ",%.17g", x);
    std::fputc('\n', file_);
  }
  if (std::ferror(file_)) fail();  // a disk that is full now will not take the rest either
}

void CsvWriter::finish() {
  if (std::fflush(file_) != 0 || std::ferror(file_)) fail();
}

void CsvWriter::fail() const {
  throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace rigid_body_sim
