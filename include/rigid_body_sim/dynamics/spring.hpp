#pragma once

#include <array>

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// Spring and damper along the line between two points, each fixed in a body or in the world: with
/// d from the first point to the second, l = |d|,
///   tension = stiffness (l − rest_length) + damping dl/dt,
/// which pulls each end towards the other, equal and opposite. V = ½ stiffness (l − rest_length)².
/// Where the ends meet (l = 0), a spring has no direction and pulls nothing.
class Spring final : public ForceLaw {
 public:
  struct End {
    std::size_t body = kWorld;          ///< index, or kWorld
    Vector3d point = Vector3d::Zero();  ///< [m] in the body's principal frame, or in the world
  };
  struct Constants {
    double stiffness = 0;    ///< [N/m] >= 0
    double damping = 0;      ///< [N s/m] >= 0
    double rest_length = 0;  ///< [m] >= 0
  };

  /// Throws std::invalid_argument for constants that break a rule, and for ends on one body.
  Spring(const End& from, const End& to, const Constants& constants);

  const char* name() const override { return "spring"; }
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
  double externalPower(const Bodies& at) const override;
  void addStiffness(const std::vector<const Body*>& bodies,
                    std::vector<Stiffness>& stiffness) const override;

  /// Its length, and that of the arms of its ends.
  double reach(const Bodies& at) const override;

  /// [N] now.
  double tension(const Bodies& at) const;

  const std::array<End, 2>& ends() const { return ends_; }

 private:
  std::array<End, 2> ends_;
  Constants constants_;
};

}  // namespace rigid_body_sim
