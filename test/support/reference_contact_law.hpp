#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

/// The force law of the independent reference of contact (reference_contact.hpp), written anew in
/// long double from the formulas of doc/contact.md.
namespace rigid_body_sim::contact_reference {

using Real = long double;
using Vec = Eigen::Matrix<Real, 3, 1>;
using Mat = Eigen::Matrix<Real, 3, 3>;
using Quat = Eigen::Quaternion<Real>;

/// Of a body whose frame lies at its centre of mass, along its principal axes.
struct Rigid {
  Real mass;
  Vec moments;
};

struct Pose {
  Vec x, v;  ///< centre of mass, world axes
  Quat q;
  Vec w;  ///< body axes
  Mat R() const;
  Vec velocityAt(const Vec& arm_W) const;
};

struct Law {
  Real k, p, d, mu, b;
};

/// Up to four points at which an element touches, with arms from both centres of mass.
struct Look {
  std::size_t count = 1;
  Vec n;  ///< from b, or the plane, to a
  std::array<Vec, 4> arm_a{}, arm_b{};
  std::array<Real, 4> depth{}, rate{};
  Vec turn = Vec::Zero();  ///< [rad/s] of the tangent plane
};

/// One place of contact, of body a with body b or, where b is none, with a plane.
struct Element {
  static constexpr std::size_t kNone = ~std::size_t{0};
  std::size_t a = 0, b = kNone;
  Real reduced_mass = 0;
  Real rim_radius = 0;  ///< of one that resists spin about the normal
  Law law{};
  std::function<Look(const std::vector<Pose>&)> look;
};

/// Modes of an element.
struct Mode {
  std::array<bool, 4> touches{}, clipped{};
  bool slips = false, spins = false;
  bool touching() const { return touches[0] || touches[1] || touches[2] || touches[3]; }
};

/// A spring and a damper behind a slider.
struct Slider {
  Vec pull, rate;
  Real excess;
  Slider(const Vec& s, const Vec& v, Real k, Real c, Real cap, bool slips);
};

/// What an element does at a look.
struct Action {
  Look look;
  std::array<Real, 4> normal{};  ///< [N]
  Real total = 0, spread = 0;    ///< [N], [N m]
  Vec center_a = Vec::Zero(), center_b = Vec::Zero();
  Vec slip = Vec::Zero();  ///< [m/s] of a over b at the centre of pressure
  Real spin = 0;           ///< [rad/s] about the normal

  Action(const Element& e, const Mode& mode, const std::vector<Pose>& at);

 private:
  void placeCenter();
};

Real springOf(const Element& e);
Real damperOf(const Element& e);

/// own: three components of the stretch, in world axes, and that of the spin.
Slider slide(const Element& e, const Mode& m, const Action& act, const Real* own);
Slider spin(const Element& e, const Mode& m, const Action& act, const Real* own);

/// Below zero where a mode is to be switched: touches of the four points, clips, slip, spin.
using Guards = std::array<Real, 10>;
Guards guardsOf(const Element& e, const Mode& m, const Real* own, const std::vector<Pose>& at);

/// Returns whether it began or ceased to touch, so that its stretches start from zero.
bool flip(Mode& m, std::size_t guard);

}  // namespace rigid_body_sim::contact_reference
