#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/buoyancy.hpp>
#include <rigid_body_sim/dynamics/central_gravity.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/spring.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/placement.hpp"
#include "support/random_bodies.hpp"
#include "support/worlds.hpp"

/// Every law of force, on two random bodies.
namespace rigid_body_sim::test {

using LawPointer = std::shared_ptr<const ForceLaw>;

/// A law for two bodies in a scene that may lie anywhere.
struct LawCase {
  const char* name;
  std::function<LawPointer(const Placement& scene)> make;
  bool damped = false;
  bool driven = false;        ///< by a wind, which may do work on the body
  std::vector<double> own{};  ///< its states; empty: as it starts
};

namespace detail {

inline MediumDrag::Coefficients everyDrag(const Placement& scene) {
  MediumDrag::Coefficients drag;
  drag.linear = {0.7, {0.1, 0.5, 0.3}};
  drag.quadratic = {0.3, {0.2, 0.1, 0.6}};
  drag.angular = {0.2, {0.4, 0.1, 0.3}};
  drag.center_P = scene.inBody(Vector3d(0.3, -0.2, 0.5));
  drag.R_PD =
      scene.inBody(Matrix3d(Quaterniond(0.3, -0.6, 0.2, 0.5).normalized().toRotationMatrix()));
  return drag;
}

inline std::vector<LawCase> lawsOfMedium() {
  const auto drag = [](const Vector3d& wind) {
    return [wind](const Placement& scene) {
      return std::make_shared<MediumDrag>(1, everyDrag(scene), scene.vector(wind));
    };
  };
  const auto quadratic = [](const Placement& scene) {
    MediumDrag::Coefficients alike;
    alike.quadratic.alike = 0.8;
    alike.center_P = scene.inBody(Vector3d(-0.1, 0.3, 0.2));
    return std::make_shared<MediumDrag>(1, alike, Vector3d::Zero());
  };
  const auto buoyancy = [](const Placement& scene) {
    return std::make_shared<Buoyancy>(1, 2.5, scene.inBody(Vector3d(-0.1, 0.4, 0.2)),
                                      scene.vector({0.5, 1, -9.8}));
  };
  return {{"drag_of_every_kind", drag(Vector3d::Zero()), true},
          {"drag_in_wind", drag({3, -1, 2}), true, true},
          {"quadratic_drag", quadratic, true},
          {"buoyancy", buoyancy}};
}

/// Taut beyond a length.
inline std::vector<LawCase> tethers(double length) {
  const auto tether = [length](double damping, bool to_world) {
    return [=](const Placement& scene) {
      const Spring::End world{kWorld, scene.point({2, -1, 3})};
      const Spring::End first{0, scene.inBody(Vector3d(0.3, -0.2, 0.5))};
      const Spring::End second{1, scene.inBody(Vector3d(-0.1, 0.4, 0.2))};
      return std::make_shared<Tether>(to_world ? world : first, second,
                                      Tether::Constants{40, damping, length});
    };
  };
  constexpr double kTaut = 1;
  return {{"tether", tether(0, false), false, false, {kTaut}},
          {"damped_tether", tether(3, false), true, false, {kTaut}},
          {"tether_to_the_world", tether(3, true), true, false, {kTaut}}};
}

inline std::vector<LawCase> springsAndGravity() {
  const Vector3d p(0.3, -0.2, 0.5), q(-0.1, 0.4, 0.2), place(2, -1, 3);
  const auto spring = [=](double stiffness, double damping) {
    return [=](const Placement& scene) {
      return std::make_shared<Spring>(Spring::End{0, scene.inBody(p)},
                                      Spring::End{1, scene.inBody(q)},
                                      Spring::Constants{stiffness, damping, 0.7});
    };
  };
  const auto anchored = [=](bool from_world) {
    return [=](const Placement& scene) {
      const Spring::End world{kWorld, scene.point(place)}, body{1, scene.inBody(q)};
      return std::make_shared<Spring>(from_world ? world : body, from_world ? body : world,
                                      Spring::Constants{40, 3, 0.7});
    };
  };
  const auto gravity = [=](bool gradient) {
    return [=](const Placement& scene) {
      return std::make_shared<CentralGravity>(1, scene.point(place), 7.0, gradient);
    };
  };
  return {{"spring", spring(40, 0)},
          {"damped_spring", spring(40, 3), true},
          {"damper", spring(0, 3), true},
          {"spring_from_the_world", anchored(true), true},
          {"spring_to_the_world", anchored(false), true},
          {"central_gravity", gravity(false)},
          {"central_gravity_with_gradient", gravity(true)}};
}

}  // namespace detail

inline std::vector<LawCase> everyLaw() {
  std::vector<LawCase> all = detail::springsAndGravity();
  for (const auto& more : {detail::lawsOfMedium(), detail::tethers(0.01)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Two random bodies in random motion.
struct Pair {
  explicit Pair(unsigned seed) {
    Draw draw(seed);
    for (int i = 0; i < 2; ++i) {
      bodies.push_back(draw.box(1));
      states.push_back(draw.state(bodies.back(), draw.uniform(0, 5)));
    }
  }

  /// The states of a law that is its own.
  static std::vector<double> ownOf(const ForceLaw& law, const LawCase& of) {
    std::vector<double> own(law.stateCount());
    law.setStart(own.data());
    return of.own.empty() ? own : of.own;
  }

  std::vector<Wrench> wrenches(const ForceLaw& law, const std::vector<double>& own = {}) const {
    std::vector<Wrench> result(2);
    law.addWrenches({pointers(), states, own.data()}, result);
    return result;
  }
  double potentialEnergy(const ForceLaw& law) const {
    return law.potentialEnergy({pointers(), states});
  }
  double externalPower(const ForceLaw& law, const std::vector<double>& own = {}) const {
    return law.externalPower({pointers(), states, own.data()});
  }

  /// As the bodies are dt later, to first order and with unit quaternions.
  Pair movedOn(double dt) const {
    Pair later = *this;
    for (std::size_t i = 0; i < 2; ++i) {
      BodyState& s = later.states[i];
      s.x_W += dt * s.p_W / bodies[i].mass;
      const Vector3d w_P = angularVelocity(bodies[i].inv_I, s.L_P);
      s.q_WP = product(s.q_WP, rotationExp(Vector3d(dt * w_P)));
    }
    return later;
  }

  Pair placed(const Placement& scene) const {
    Pair result = *this;
    for (BodyState& s : result.states) s = scene.state(s);
    return result;
  }

  std::vector<const Body*> pointers() const { return {&bodies[0], &bodies[1]}; }

  std::vector<Body> bodies;
  std::vector<BodyState> states;
};

}  // namespace rigid_body_sim::test
