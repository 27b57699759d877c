#pragma once

#include "dynamics/contact/contact_law.hpp"
#include "dynamics/contact/feature.hpp"
#include "dynamics/contact/normal_law.hpp"

namespace rigid_body_sim {

/// Contact of two bodies made of balls, each ball of one with each of the other.
class BallContact final : public ContactLaw {
 public:
  struct Side {
    std::size_t body = 0;   ///< index, or kWorld where the balls never move
    std::size_t label = 0;  ///< index in the world
    std::vector<Feature> balls;
  };

  /// mass [kg]: the reduced mass.
  BallContact(Side a, Side b, const ContactParameters& parameters, double mass);

  std::vector<std::size_t> members() const override;
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override;

  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  void addWrenchesAndRates(const Bodies& at, std::vector<Wrench>& wrenches,
                           double* rates) const override;
  double potentialEnergy(const Bodies& at) const override;
  double externalPower(const Bodies& at) const override;
  double rate(const Bodies& at, const std::vector<double>& speeds) const override;
  double reach(const Bodies& at) const override;

  std::size_t stateCount() const override { return pairCount() * kOwnCount; }
  bool admits(const double* own) const override;
  void setRates(const Bodies& at, double* rates) const override;
  std::size_t guardCount() const override { return pairCount() * kGuardCount; }
  void setGuards(const Bodies& at, double* guards) const override;
  void switchMode(std::size_t guard, const Bodies& at, double* own) const override;
  bool acts(const double* own) const override;

  double quietInFlight(double t, const Bodies& at,
                       const std::vector<MotionBound>& bounds) const override;
  double longestStep(const Bodies& at, double precision) const override;
  double touchRadius(std::size_t k) const override;
  bool holdsStill(const Bodies& at, const std::vector<Stray>& strays) const override;
  void addContacts(const Bodies& at, std::vector<ContactPoint>& contacts) const override;
  void addContactEvents(const Bodies& at, const double* before,
                        std::vector<ContactEvent>& events) const override;

 private:
  // states of a pair: its mode, and the stretch of its bristle, a vector of the world
  enum Own : std::size_t { kMode, kStretch, kOwnCount = 4 };
  enum Mode : unsigned { kTouches = 1, kClips = 2, kSlips = 4 };
  enum Guard : std::size_t { kTouch, kPull, kSlip, kGuardCount };
  static unsigned modeOf(const double* own) { return static_cast<unsigned>(own[kMode]); }

  /// How a side moves.
  struct Frame {
    Vector3d x_W = Vector3d::Zero(), low_W = Vector3d::Zero();  ///< [m] centre of mass
    Vector3d v_W = Vector3d::Zero(), w_W = Vector3d::Zero();    ///< [m/s], [rad/s]
    Quaterniond q_WP = Quaterniond::Identity();
  };
  /// All that follows from the motion of a pair.
  struct Now {
    unsigned mode;
    NormalPoint point;
    double distance;            ///< [m] of the centres
    Vector3d n_W;               ///< from b to a
    Vector3d arm_a_W, arm_b_W;  ///< [m] of the point where the force acts
    Vector3d slip_W;            ///< [m/s] of a over b there, along the tangent plane
    Vector3d turn_W;            ///< [rad/s] of the tangent plane
  };
  using Pull = BristlePull<Vector3d>;

  std::size_t pairCount() const { return a_.balls.size() * b_.balls.size(); }
  static Frame frameOf(const Side& side, const Bodies& at);
  Now now(std::size_t pair, const Frame& a, const Frame& b, unsigned mode) const;
  Pull pull(const Now& now, const double* own) const;
  Vector3d forceOnA(const Now& now, const double* own) const;
  void addForceOnA(const Now& now, const Vector3d& f_W, std::vector<Wrench>& wrenches) const;
  void setRateOf(const Now& now, const double* own, double* rates) const;
  template <class F>
  void forPairs(const Bodies& at, const double* own, const F& f) const;
  template <class F>
  void forTouching(const Bodies& at, const double* own, const F& f) const;

  Side a_, b_;
  ContactParameters c_;
  double mass_;
  Bristle bristle_;
};

template <class F>
void BallContact::forPairs(const Bodies& at, const double* own, const F& f) const {
  const Frame a = frameOf(a_, at), b = frameOf(b_, at);
  for (std::size_t pair = 0; pair < pairCount(); ++pair, own += kOwnCount)
    f(pair, now(pair, a, b, modeOf(own)), own);
}

template <class F>
void BallContact::forTouching(const Bodies& at, const double* own, const F& f) const {
  if (!acts(own)) return;
  const Frame a = frameOf(a_, at), b = frameOf(b_, at);
  for (std::size_t pair = 0; pair < pairCount(); ++pair, own += kOwnCount)
    if (modeOf(own) & kTouches) f(pair, now(pair, a, b, modeOf(own)), own);
}

}  // namespace rigid_body_sim
