#include "tools/simulate/imu_csv.hpp"

#include <algorithm>
#include <limits>

#include "math/instant_rounding.hpp"

namespace rigid_body_sim {

ImuCsv::ImuCsv(const std::string& path, const Simulation& simulation)
    : simulation_(simulation), file_(path, "time,body,imu,gx,gy,gz,ax,ay,az") {
  for (const Imu& imu : simulation.world().imus)
    instants_.emplace_back(imu.rate, simulation.time());
}

double ImuCsv::next() const {
  double next = std::numeric_limits<double>::infinity();
  for (const Instants& instants : instants_) next = std::min(next, instants.next());
  return next;
}

void ImuCsv::writeDue() {
  const double t = simulation_.time();
  writeAt(t, t + instantRounding(t, simulation_.world().solver.time_step));
}

void ImuCsv::writeWithinStep(double t_end) {
  const double h = simulation_.world().solver.time_step;
  const double t_step = static_cast<double>(simulation_.steps() + 1) * h;
  const double reach = t_end + instantRounding(t_end, h);
  const double before = t_step - instantRounding(t_step, h);
  for (double t = next(); t <= reach && t < before; t = next()) writeAt(t, t);
}

/// The samples of instants that miss t [s] by no more than `reach` does.
void ImuCsv::writeAt(double t, double reach) {
  const std::vector<Imu>& imus = simulation_.world().imus;
  std::FILE* const out = file_.stream();
  for (std::size_t i = 0; i < imus.size(); ++i) {
    const auto sample = instants_[i].take(t - (reach - t), reach);
    const Body& body = simulation_.world().bodies[imus[i].body];
    if (!sample || body.absent) continue;
    StatesWithin& within = within_.try_emplace(imus[i].rate, imus[i].rate).first->second;
    const std::vector<BodyMotion> motions = t > simulation_.time()
                                                ? within.motions(simulation_, {imus[i].body}, t)
                                                : simulation_.motions({imus[i].body}, t);
    const ImuReading reading = readImu(imus[i], body, motions[0]);
    std::fprintf(out, "%.17g,%s,%s", static_cast<double>(*sample) / imus[i].rate, body.name.c_str(),
                 imus[i].name.c_str());
    for (const Vector3d& v : {reading.w_S, reading.f_S})
      std::fprintf(out, ",%.17g,%.17g,%.17g", v.x(), v.y(), v.z());
    std::fputc('\n', out);
  }
  file_.check();
}

}  // namespace rigid_body_sim
