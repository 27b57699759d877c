#pragma once

#include <cstddef>
#include <vector>

#include "support/reference_contact_law.hpp"

/// An independent reference of contact: bodies, the law (reference_contact_law.hpp) and its events
/// in long double, advanced by the classical Runge-Kutta method at tiny steps, events by bisection.
/// It uses nothing of the product.
namespace rigid_body_sim::contact_reference {

class Scene {
 public:
  Vec g = Vec::Zero();
  std::vector<Rigid> bodies;
  std::vector<Element> elements;
  Real flight_step = 4e-4L, contact_step = 1e-5L;  ///< [s]

  /// What follows at time `duration` from these poses, bristles not stretched.
  std::vector<Pose> run(const std::vector<Pose>& start, Real duration);

  /// The same at the ends of equal intervals, the start first.
  std::vector<std::vector<Pose>> track(const std::vector<Pose>& start, Real duration,
                                       int intervals);

 private:
  static constexpr std::size_t kBody = 13, kOwn = 4;
  using Numbers = std::vector<Real>;
  struct Load {
    Vec force, torque = Vec::Zero();
  };

  void begin(const std::vector<Pose>& start);
  void goOn(Real duration);
  void setPose(std::size_t i, const Pose& p);
  std::vector<Pose> poses(const Numbers& y) const;
  const Real* ownOf(const Numbers& y, std::size_t k) const;
  Numbers rates(const Numbers& y) const;
  void addElement(std::size_t k, const std::vector<Pose>& at, const Real* own,
                  std::vector<Load>& loads, Real* own_dot) const;
  static void setRates(const Rigid& body, const Pose& p, const Load& load, Real* d);
  Numbers stepped(Real h) const;
  bool isBelow(const Numbers& y) const;
  void switchModes();

  /// Where a force rises as a power that is no whole number, steps grow with the time since.
  Real longestStep() const;

  /// A step of at most h, up to the first event. Returns its length.
  Real advance(Real h);

  Numbers y_;
  std::vector<Mode> modes_;
};

}  // namespace rigid_body_sim::contact_reference
