#pragma once

#include <array>

#include <rigid_body_sim/dynamics/spring.hpp>

namespace rigid_body_sim {

/// A line between two points, each fixed in a body or in the world, that pulls and never pushes:
/// with l its length,
///   tension = max(0, stiffness (l − length) + damping dl/dt)   where l > length,  else 0,
/// equal and opposite at its ends. V = ½ stiffness max(0, l − length)².
///
/// Its state tells which of three modes it is in; each change is an event:
///   slack  l <= length: it does not act. It becomes taut where l exceeds the length; with damping
///          the tension jumps to damping dl/dt there
///   taut   it becomes limp where the tension falls to zero, with damping before l is back at the
///          length
///   limp   l > length, but it shortens faster than the spring would draw it in, so that the
///          tension is zero: the damper then dissipates what the spring still holds. It becomes
///          slack at the length, or taut again
class Tether final : public ForceLaw {
 public:
  struct Constants {
    double stiffness = 0;  ///< [N/m] > 0
    double damping = 0;    ///< [N s/m] >= 0
    double length = 0;     ///< [m] > 0, up to which it is slack
  };

  /// Throws std::invalid_argument for constants that break a rule, and for ends on one body.
  Tether(const Spring::End& from, const Spring::End& to, const Constants& constants);

  const char* name() const override { return "tether"; }
  std::vector<std::size_t> members() const override;
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override;
  unsigned needs() const override {
    return constants_.damping > 0 ? kCoupling | kDamping : kCoupling;
  }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  double potentialEnergy(const Bodies& at) const override;

  /// −(tension − stiffness (l − length)) dl/dt <= 0 where l > length.
  double externalPower(const Bodies& at) const override;

  void addStiffness(const std::vector<const Body*>& bodies,
                    std::vector<Stiffness>& stiffness) const override;
  double reach(const Bodies& at) const override;

  std::size_t stateCount() const override { return 1; }
  bool admits(const double* own) const override {
    return own[0] == kSlack || own[0] == kTaut || own[0] == kLimp;
  }
  std::size_t guardCount() const override { return 2; }
  void setGuards(const Bodies& at, double* guards) const override;
  void switchMode(std::size_t guard, const Bodies& at, double* own) const override;
  bool acts(const double* own) const override { return own[0] != kSlack; }
  bool isOneSided() const override { return true; }
  bool switchesSmoothly() const override { return constants_.damping == 0; }

  /// While slack, until the ends could be further apart than the length.
  double quietInFlight(double t, const Bodies& at,
                       const std::vector<MotionBound>& bounds) const override;

  /// [N] now.
  double tension(const Bodies& at) const;

  /// Whether it pulls, in the mode that its own states tell.
  bool isTaut(const double* own) const { return own[0] == kTaut; }

  const std::array<Spring::End, 2>& ends() const { return ends_; }

 private:
  static constexpr double kSlack = 0, kTaut = 1, kLimp = 2;

  std::array<Spring::End, 2> ends_;
  Constants constants_;
};

}  // namespace rigid_body_sim
