#pragma once

#include "dynamics/contact/contact_law.hpp"
#include "dynamics/contact/feature.hpp"
#include "dynamics/contact/normal_law.hpp"
#include "dynamics/contact/swings.hpp"

namespace rigid_body_sim {

/// A half-space and its axes in the world.
struct Plane {
  HalfSpace half_space;
  Vector3d n_W, e1_W, e2_W;  ///< the normal, and two along the plane

  explicit Plane(const HalfSpace& of)
      : half_space(of),
        n_W(rotate(of.q_WH, Vector3d(Vector3d::UnitZ()))),
        e1_W(rotate(of.q_WH, Vector3d(Vector3d::UnitX()))),
        e2_W(rotate(of.q_WH, Vector3d(Vector3d::UnitY()))) {}
};

/// A feature against a plane: one element of a contact, with states and modes of its own.
class Patch {
 public:
  /// Its states: the modes as a sum of bits, and the stretches of its bristles.
  enum Own : std::size_t { kMode, kSlideStretch, kSpinStretch = 3, kRollStretch, kOwnCount = 6 };

  /// mass [kg]: of the body.
  Patch(const Feature& feature, const ContactParameters& parameters, double mass);

  const Feature& feature() const { return feature_; }

  /// The same feature, in a principal frame that has moved in the body. The lever of rolling
  /// friction stays.
  void setFeature(const Feature& feature) {
    feature_ = feature;
    reach_ = feature.reach();
  }

  /// Modes. Bit j: point j touches; 4 + j: it would pull; then: the bristles slip.
  enum Mode : unsigned { kTouches = 1, kClips = 16, kSlips = 256, kSpins = 512, kRolls = 1024 };
  static unsigned modeOf(const double* own) { return static_cast<unsigned>(own[kMode]); }
  static bool admits(const double* own) { return isSumOfBits(own[kMode], 2 * kRolls - 1); }
  static bool touches(unsigned mode) { return (mode & 15U) != 0; }

  /// Place of the body against the plane.
  struct Pose {
    const Body& body;
    const BodyState& state;
    const Vector3d &o_W, &n_W, &e1_W, &e2_W;  ///< a point of the plane, and its axes
    Vector3d v_W, w_W;                        ///< of the body [m/s], [rad/s]
    double height;                            ///< [m] of the centre of mass; its small part apart
    double height_low;

    Pose(const Body& on, const BodyState& at, const Plane& against);

    /// [m] Of a point at a height from the centre of mass. The large parts first: near a touch they
    /// cancel, and the small one keeps its digits.
    double depthAt(double point_height) const { return -(height + point_height) - height_low; }

    /// [m] Of the terms that the height of the centre of mass is a sum of.
    double size() const { return n_W.cwiseAbs().dot((state.x_W - o_W).cwiseAbs()); }
  };

  /// All that forces, rates and guards follow from.
  struct Now {
    unsigned mode;
    std::size_t count;
    std::array<Vector3d, 4> arm_W;  ///< [m]
    std::array<NormalPoint, 4> point;
    double normal = 0;        ///< Σ f_j [N], of those that touch
    Vector3d center_W;        ///< [m] arm of the centre of pressure
    double spread = 0;        ///< Σ f_j |r_j − center| [N m]
    Eigen::Vector2d v, roll;  ///< [m/s], [rad/s] along the plane
    double spin = 0;          ///< [rad/s] about the normal
  };
  Now now(const Pose& pose, const double* own) const;

  void addWrench(const Pose& pose, const double* own, Wrench& wrench) const;
  void addWrenchAndRates(const Pose& pose, const double* own, Wrench& wrench, double* rates) const;
  Vector3d friction(const Pose& pose, const Now& now, const double* own) const;  ///< [N]
  void setRates(const Pose& pose, const double* own, double* rates) const;
  double potentialEnergy(const Pose& pose, const double* own) const;
  double externalPower(const Pose& pose, const double* own) const;

  /// Adds its springs and dampers at the present state. Returns the rate [1/s] at which bristles
  /// that slip relax.
  double addSwings(const Pose& pose, const double* own, Swings& swings) const;

  /// [s] See ForceLaw::longestStep.
  double longestStep(const Pose& pose, const double* own, double precision) const;

  /// See ForceLaw::holdsStill; of the body.
  bool holdsStill(const Pose& pose, const double* own, const Stray& stray) const;

  /// Guards: of each point its touch and its pull; of the bristles.
  std::size_t guardCount() const { return 2 * feature_.pointCount() + 3; }
  void setGuards(const Pose& pose, const double* own, double* guards) const;
  void switchMode(std::size_t guard, double* own) const;

 private:
  using Vector1d = Eigen::Matrix<double, 1, 1>;
  BristlePull<Eigen::Vector2d> slide(const Now& now, const double* own) const;
  BristlePull<Vector1d> spin(const Now& now, const double* own) const;
  BristlePull<Eigen::Vector2d> roll(const Now& now, const double* own) const;
  void addWrenchOf(const Pose& pose, const Now& now, const double* own, Wrench& wrench) const;
  void setRatesOf(const Now& now, const double* own, double* rates) const;
  bool holdsSpin(const Now& now, const double* own, const Stray& stray, double loss) const;
  bool setGuardsApart(const Pose& pose, double depth_rounding, double* guards) const;
  void placeFriction(const Pose& pose, Now& now) const;
  bool spins() const { return bristle_.exists() && feature_.kind == Feature::Kind::kRim; }

  Feature feature_;
  ContactParameters c_;
  double mass_, lever_;
  double reach_;  // [m] of the feature
  Bristle bristle_, spinning_, rolling_;
};

}  // namespace rigid_body_sim
