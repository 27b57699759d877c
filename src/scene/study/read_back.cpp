#include "scene/study/read_back.hpp"

#include <algorithm>
#include <cmath>

#include "scene/study/scene_path.hpp"

namespace rigid_body_sim {

ReadBack::ReadBack(const std::string& path, std::size_t body) : body_(body) {
  std::vector<PathStep> steps = stepsOf(path);
  if (steps.back().item) {
    item_ = static_cast<Eigen::Index>(*steps.back().item);
    steps.pop_back();
  }
  if (steps.size() == 3 && steps[0].name == "wrenches") wrench_ = steps[1].item;
  const std::size_t first = body != VariedScene::kNoBody ? 2 : wrench_ ? 2 : 0;
  for (std::size_t i = first; i < steps.size(); ++i)
    whole_ +=
        (i > first ? "." : "") + (steps[i].item ? std::to_string(*steps[i].item) : steps[i].name);
}

std::optional<double> ReadBack::solverNumber(const World& world) const {
  if (body_ != VariedScene::kNoBody || item_) return std::nullopt;
  if (wrench_) {
    const PointWrench& wrench = world.wrenches[*wrench_];
    if (whole_ == "start") return wrench.start;
    if (whole_ == "duration") return wrench.end - wrench.start;
    return std::nullopt;
  }
  if (whole_ == "tolerance") return world.solver.tolerance;
  if (whole_ == "time_step") return world.solver.time_step;
  if (whole_ == "horizon") return world.solver.horizon;
  return std::nullopt;
}

std::optional<double> ReadBack::bodyNumber(const World& world) const {
  if (body_ == VariedScene::kNoBody || item_) return std::nullopt;
  const Body& body = world.bodies[body_];
  if (whole_ == "mass") return body.mass;
  static const std::vector<std::pair<std::string, std::pair<int, int>>> moments = {
      {"inertia.ixx", {0, 0}}, {"inertia.iyy", {1, 1}}, {"inertia.izz", {2, 2}},
      {"inertia.ixy", {0, 1}}, {"inertia.ixz", {0, 2}}, {"inertia.iyz", {1, 2}}};
  for (const auto& [key, at] : moments) {
    if (whole_ != key || !body.actuators.empty()) continue;
    // on a pivot I is about it; elsewhere com_P is zero
    const Matrix3d R = body.X_BP.linear(), I_P = body.I.asDiagonal();
    const Vector3d& c = body.com_P;
    const Matrix3d arm = c.squaredNorm() * Matrix3d::Identity() - c * c.transpose();
    const Matrix3d inertia = R * (I_P - body.mass * arm) * R.transpose();
    return inertia(at.first, at.second);
  }
  return std::nullopt;
}

std::optional<Vector3d> ReadBack::vector(const Scene& scene, const World& world,
                                         const State& initial) const {
  if (whole_ == "gravity" && !wrench_) return world.g_W;
  if (body_ == VariedScene::kNoBody) return std::nullopt;
  const Body& body = world.bodies[body_];
  if (whole_ == "center_of_mass") return Vector3d(body.X_BP * body.com_P);
  const bool angular = whole_ == "twist.angular";
  if (whole_ != "position" && !angular && whole_ != "twist.linear") return std::nullopt;
  const BodyFrameMotion motion = toBodyFrameMotion(body, initial.bodies[body_]);
  if (whole_ == "position") return motion.x_W;
  const Vector3d v_W = angular ? motion.w_W : motion.v_W;
  if (!scene.bodies[body_].twist.in_body_axes) return v_W;
  return Vector3d(motion.q_WB.conjugate() * v_W);
}

std::optional<ReadBack::Numbers> ReadBack::numbers(const Scene& scene, const World& world,
                                                   const State& initial) const {
  const auto one = [](double x) -> Numbers { return Numbers::Constant(1, x); };
  if (const std::optional<double> number = solverNumber(world)) return one(*number);
  if (const std::optional<double> number = bodyNumber(world)) return one(*number);
  Numbers all;
  if (whole_ == "orientation" && body_ != VariedScene::kNoBody) {
    all = toBodyFrameMotion(world.bodies[body_], initial.bodies[body_]).q_WB.coeffs();
  } else if (const std::optional<Vector3d> v = vector(scene, world, initial)) {
    all = *v;
  } else {
    return std::nullopt;
  }
  if (!item_) return all;
  return one(all[*item_]);
}

std::optional<SceneValue> otherReadBack(const SceneValue& given,
                                        const std::optional<ReadBack::Numbers>& world) {
  constexpr double kRounding = 1e-9;
  if (!world || world->size() != static_cast<Eigen::Index>(given.words.size())) return std::nullopt;
  double scale = 0, same = 0, opposite = 0;
  for (Eigen::Index i = 0; i < world->size(); ++i) {
    const std::optional<double>& x = given.words[static_cast<std::size_t>(i)].number;
    if (!x) return std::nullopt;
    scale = std::max(scale, std::abs(*x));
    same = std::max(same, std::abs((*world)[i] - *x));
    opposite = std::max(opposite, std::abs((*world)[i] + *x));
  }
  // q and −q are one attitude
  if (world->size() == 4) same = std::min(same, opposite);
  if (!(same > kRounding * scale)) return std::nullopt;
  if (!given.is_list) return SceneValue::of((*world)[0]);
  return SceneValue::of(std::vector<double>(world->data(), world->data() + world->size()));
}

}  // namespace rigid_body_sim
