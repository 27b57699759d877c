#include "reference_run.hpp"

#include <algorithm>
#include <stdexcept>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

namespace rigid_body_sim {

double distance(const Motion& a, const Motion& b) {
  return std::max({(a.position - b.position).cwiseAbs().maxCoeff(),
                   angleBetween(a.attitude, b.attitude),
                   (a.linear_B - b.linear_B).cwiseAbs().maxCoeff(),
                   (a.angular_B - b.angular_B).cwiseAbs().maxCoeff()});
}

ReferenceRun::ReferenceRun(const std::string& scene_path) : simulation_(nullptr) {
  const Scene scene = loadScene(scene_path);
  const World world = buildWorld(scene);
  simulation_ = new Simulation(world, initialState(scene, world));
}

ReferenceRun::ReferenceRun(const ReferenceRun& other)
    : simulation_(new Simulation(*other.simulation_)) {}

ReferenceRun& ReferenceRun::operator=(const ReferenceRun& other) {
  *simulation_ = *other.simulation_;
  return *this;
}

ReferenceRun::~ReferenceRun() { delete simulation_; }

void ReferenceRun::step() { simulation_->step(); }

void ReferenceRun::reset() { simulation_->reset(false); }

void ReferenceRun::clear(const std::string& body) { simulation_->clearWrenches(index(body)); }

double ReferenceRun::time() const { return simulation_->time(); }

std::size_t ReferenceRun::index(const std::string& body) const {
  const std::vector<Body>& bodies = simulation_->world().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].name == body) return i;
  }
  throw std::out_of_range(body);
}

Motion ReferenceRun::motion(const std::string& body) const {
  const std::size_t i = index(body);
  const BodyFrameMotion m = toBodyFrameMotion(simulation_->world().bodies[i], simulation_->body(i));
  return {m.x_W, m.q_WB, m.q_WB.conjugate() * m.v_W, m.q_WB.conjugate() * m.w_W};
}

void ReferenceRun::pushAtCenterOfMass(const std::string& slot, const std::string& body,
                                      const Vector3d& f_W, const Vector3d& tau_W, Span span) {
  PointWrench applied;
  applied.body = applied.point_frame = index(body);
  applied.force = f_W;
  applied.torque = tau_W;
  applied.start = span.start;
  applied.end = span.start + span.duration;
  simulation_->applyWrench(slot, applied);
}

void ReferenceRun::pushAtPoint(const std::string& slot, const std::string& body,
                               const Vector3d& f_W, const Vector3d& tau_W, const Vector3d& point_B,
                               Span span) {
  PointWrench applied;
  applied.body = applied.point_frame = index(body);
  applied.force = f_W;
  applied.torque = tau_W;
  applied.point = simulation_->world().bodies[applied.body].X_BP.inverse() * point_B;
  applied.start = span.start;
  applied.end = span.start + span.duration;
  simulation_->applyWrench(slot, applied);
}

void ReferenceRun::pushAtFrame(const std::string& slot, const std::string& body,
                               const Vector3d& f_F, const Vector3d& tau_F, const Isometry3d& X_BF,
                               Span span) {
  PointWrench applied;
  applied.body = applied.axes = applied.point_frame = index(body);
  const Isometry3d X_PF = simulation_->world().bodies[applied.body].X_BP.inverse() * X_BF;
  applied.force = X_PF.linear() * f_F;
  applied.torque = X_PF.linear() * tau_F;
  applied.point = X_PF.translation();
  applied.start = span.start;
  applied.end = span.start + span.duration;
  simulation_->applyWrench(slot, applied);
}

}  // namespace rigid_body_sim
