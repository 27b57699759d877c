#include "tools/simulate/csv_writer.hpp"

#include "tools/common/csv_header.hpp"
#include "tools/common/motion_numbers.hpp"

namespace rigid_body_sim {

CsvWriter::CsvWriter(const std::string& path) : file_(path, kCsvHeader) {}

void CsvWriter::write(const World& world, const State& state) {
  std::FILE* const out = file_.stream();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    if (body.absent) continue;
    std::fprintf(out, "%.17g,%s", state.t, body.name.c_str());
    for (const double x : motionNumbers(toBodyFrameMotion(body, state.bodies[i])))
      std::fprintf(out, ",%.17g", x);
    std::fputc('\n', out);
  }
  file_.check();
}

}  // namespace rigid_body_sim
