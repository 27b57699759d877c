#include "tools/simulate/csv_writer.hpp"

#include "tools/common/csv_header.hpp"

namespace rigid_body_sim {

CsvWriter::CsvWriter(const std::string& path) : file_(path, kCsvHeader) {}

void CsvWriter::write(const World& world, const State& state) {
  std::FILE* const out = file_.stream();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    const BodyFrameMotion m = toBodyFrameMotion(body, state.bodies[i]);
    std::fprintf(out, "%.17g,%s", state.t, body.name.c_str());
    for (double x : {m.x_W.x(), m.x_W.y(), m.x_W.z(), m.q_WB.x(), m.q_WB.y(), m.q_WB.z(),
                     m.q_WB.w(), m.v_W.x(), m.v_W.y(), m.v_W.z(), m.w_W.x(), m.w_W.y(), m.w_W.z()})
      std::fprintf(out, ",%.17g", x);
    std::fputc('\n', out);
  }
  file_.check();
}

}  // namespace rigid_body_sim
