#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <rigid_body_sim/dynamics/acceleration.hpp>
#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// How fast laws make one body swing and slow down, whatever the state: sums over the laws on it.
struct Stiffness {
  double frequency_squared = 0;  ///< [1/s²] bound on that of its swings
  double decay = 0;              ///< [1/s] bound on the rate of its damping
};

/// What an integrator must support to advance bodies under a law or a wrench; needs add up by |.
enum Need : unsigned {
  kCoupling = 1,   ///< wrenches that depend on place and attitude of any of the bodies
  kDrag = 2,       ///< drag, which has a flow of its own (ForceLaw::kick)
  kDamping = 4,    ///< other wrenches that depend on velocities
  kLawStates = 8,  ///< states of a law that change with time (ForceLaw::setRates)
  kContact = 16,   ///< many events, between which forces rise from zero by a power of time
  kThrust = 32,    ///< forces and torques of motors, which follow their commands with a lag
  kSpin = 64       ///< angular momentum of wheels and rotors
};

struct MediumLoad;

/// What is known of the motion of a body that no law disturbs, up to a time.
struct MotionBound {
  Vector3d a_W = Vector3d::Zero();  ///< [m/s²] its acceleration lies within a_off of this
  double a_off = 0;                 ///< [m/s²]
  double torque = 0;                ///< [N m] no torque on it exceeds this
  double until = 0;                 ///< [s]
};

/// Bounds on how far a body strays from a state.
struct Stray {
  double place = 0;  ///< [m]
  double turn = 0;   ///< [rad]
  double speed = 0;  ///< [m/s]
  double spin = 0;   ///< [rad/s]

  /// Of a point that turns with the body, at a distance [m] from the centre of mass.
  double placeAt(double arm) const { return place + arm * turn; }
  double speedAt(double arm) const { return speed + arm * spin; }
};

/// A law of force between bodies, points and the world. It never changes: it adds the wrenches that
/// follow from where the bodies are, how they move, and its own states, which belong to State.
///
/// Over every motion, with F the law's wrenches and V its potential energy,
///   Σ f · v + τ · ω = −dV/dt + externalPower.
class ForceLaw {
 public:
  /// The bodies of a world or of a part of it, and their states, index by index. Where a body is,
  /// is x_W + x_low_W: within a step an integrator puts what it moves a body by into x_low_W.
  struct Bodies {
    const std::vector<const Body*>& bodies;
    const std::vector<BodyState>& states;
    const double* own = nullptr;  ///< the law's own states, stateCount() of them
  };

  virtual ~ForceLaw() = default;

  /// For messages, such as "spring".
  virtual const char* name() const = 0;

  /// Indices of the bodies it acts on: at least one, none of them fixed.
  virtual std::vector<std::size_t> members() const = 0;

  /// The same law where the body of index i has index index(i).
  virtual std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const = 0;

  /// The same law where the mass properties of its member i have changed, and its principal frame P
  /// with them: what is fixed to the body stays where it is in the body frame B. Null where the law
  /// cannot follow such a change, which is then refused.
  virtual std::shared_ptr<const ForceLaw> reframed(std::size_t /*body*/, const Body& /*before*/,
                                                   const Body& /*after*/) const {
    return nullptr;
  }

  /// What an integrator must support (Need), something at least: kCoupling where a wrench depends
  /// on nothing that is named there.
  virtual unsigned needs() const = 0;

  /// Adds the wrench on each body.
  virtual void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const = 0;

  /// [J]
  virtual double potentialEnergy(const Bodies& at) const = 0;

  /// [W] Power that does not come out of the potential: negative where the law dissipates.
  virtual double externalPower(const Bodies& at) const = 0;

  /// Adds, body by body, bounds on how fast the law makes it swing and slow down at any state, so
  /// that steps can be kept short enough.
  virtual void addStiffness(const std::vector<const Body*>& /*bodies*/,
                            std::vector<Stiffness>& /*stiffness*/) const {}

  /// [1/s] A bound, beside that, on the rate at which the law's wrenches change near these states,
  /// where the speeds are at most those given [m/s], body by body.
  virtual double rate(const Bodies& /*at*/, const std::vector<double>& /*speeds*/) const {
    return 0;
  }

  /// Whether rate() may be above zero.
  virtual bool hasRate() const { return false; }

  /// Whether rate() depends on the speeds.
  virtual bool rateGrowsWithSpeed() const { return false; }

  /// Whether its wrenches may have a kink, or nearly one, at instants that are no events: an
  /// integrator of high order errs across it by far more than its estimates say.
  virtual bool hasKink() const { return false; }

  /// [s] From the present to the nearest kink that a step of h may suffer from, the motion of its
  /// bodies given index by index of `at`. A kink that changes less than the share `negligible` of
  /// what changes within h is taken to be farther off than it is. Steps of at most a third of the
  /// result do not suffer.
  virtual double distanceToKink(const Bodies& at, const std::vector<BodyMotion>& motions, double h,
                                double negligible) const;

  /// [m] The greatest length over which the law subtracts positions, by which rounding errs in it.
  virtual double reach(const Bodies& /*at*/) const { return 0; }

  /// Whether the law implements kick().
  virtual bool hasFlow() const { return false; }

  /// The flow over h [s] of the law together with a wrench on its only body, at fixed place and
  /// attitude. Integrators that kick and drift use it in place of h × the law's wrench, so that
  /// they follow the law however stiff it is. At most one law with a flow acts on a body.
  virtual void kick(const Body& /*body*/, const Wrench& /*wrench*/, double /*h*/,
                    BodyState& /*state*/) const {}

  /// Number of scalars that the law carries from step to step: those that change with time and
  /// those that say in which of its modes it is.
  virtual std::size_t stateCount() const { return 0; }

  /// Their values at the start, and their rates of change; zero where they are not given.
  virtual void setStart(double* own) const;
  virtual void setRates(const Bodies& at, double* rates) const;

  /// addWrenches and setRates at once, for laws in which they share computations.
  virtual void addWrenchesAndRates(const Bodies& at, std::vector<Wrench>& wrenches,
                                   double* rates) const {
    addWrenches(at, wrenches);
    setRates(at, rates);
  }

  /// Whether these finite values can be its own states, of which some say in which of its modes it
  /// is: they may come from a file.
  virtual bool admits(const double* /*own*/) const { return true; }

  /// Events: a step ends at the instant at which one of the guards, positive before, falls below
  /// zero; it is located to rounding of the motion. Then switchMode changes the law's own states so
  /// that no guard is below zero in the mode that begins.
  virtual std::size_t guardCount() const { return 0; }
  virtual void setGuards(const Bodies& /*at*/, double* /*guards*/) const {}
  virtual void switchMode(std::size_t /*guard*/, const Bodies& /*at*/, double* /*own*/) const {}

  /// Whether it acts in the mode that its own states say. A law that does not act adds no wrench,
  /// links no bodies and costs their motion nothing, which may be solved meanwhile; its guards are
  /// looked at on their motion, and not before quietUntil.
  virtual bool acts(const double* /*own*/) const { return true; }

  /// [s] Up to when a law that does not act at time t cannot begin to, whatever acts on its bodies.
  virtual double quietUntil(double t, const Bodies& /*at*/) const { return t; }

  /// [s] The same where the motion of its bodies is bounded, index by index of `at`: no later than
  /// the bounds hold.
  virtual double quietInFlight(double t, const Bodies& at,
                               const std::vector<MotionBound>& /*bounds*/) const {
    return quietUntil(t, at);
  }

  /// [m] Of a law between two bodies that cannot act while they are far apart: the radius of a
  /// sphere about the centre of mass of members()[k], so that it does not act while the two spheres
  /// are apart. Infinite where there is none.
  virtual double touchRadius(std::size_t k) const;

  /// Whether it acts only while its bodies touch or its line is taut, or the like, which follows
  /// from where they are and how they move. Then its own states start anew where the state of one
  /// of its bodies is set from outside: they are switched then, and at the start of a run, until no
  /// guard is below zero. While it does not act, an integrator that advances its bodies looks at
  /// its guards.
  ///
  /// In flight its quietInFlight goes by the bounds, so that no event is missed while they are
  /// known.
  virtual bool isOneSided() const { return false; }

  /// Whether its wrenches are continuous through every switch of its modes, so that an instant that
  /// is located to 1e-8 of a step costs no accuracy.
  virtual bool switchesSmoothly() const { return false; }

  /// [s] The longest step from here on that does not hide from the integrator's estimate how the
  /// law's wrenches begin; precision: of the step, relative.
  virtual double longestStep(const Bodies& at, double precision) const;

  /// Whether, while its bodies stray no further from these states than given, index by index of
  /// `at`, it switches no mode, and does nothing but follow its potential energy and dissipate; its
  /// own states are then functions of where the bodies are.
  virtual bool holdsStill(const Bodies& /*at*/, const std::vector<Stray>& /*strays*/) const {
    return false;
  }

  /// Whether it is what a medium exerts on one body, so that its motion can be solved: then
  /// addMedium puts it into a load. Of each kind, which is its name(), at most one acts on a body.
  /// For laws of this package: a MediumLoad is not public.
  virtual bool isOfMedium() const { return false; }
  virtual void addMedium(const Bodies& /*at*/, MediumLoad& /*load*/) const {}

  /// Sets the velocity of the medium [m/s], world axes, in its own states. False where it has none.
  virtual bool setMedium(const Vector3d& /*velocity_W*/, double* /*own*/) const { return false; }

  /// Of a law whose force is that of a gravitational field: its centre. An accelerometer does not
  /// read such a force. Null of any other law.
  virtual const GravityCenter* gravityCenter() const { return nullptr; }

  /// Adds what touches now.
  virtual void addContacts(const Bodies& /*at*/, std::vector<ContactPoint>& /*contacts*/) const {}

  /// Adds the touches and releases that changed its own states from `before`, their instants left
  /// out.
  virtual void addContactEvents(const Bodies& /*at*/, const double* /*before*/,
                                std::vector<ContactEvent>& /*events*/) const {}

 protected:
  ForceLaw() = default;
  ForceLaw(const ForceLaw&) = default;
  ForceLaw& operator=(const ForceLaw&) = default;
};

using ForceLaws = std::vector<std::shared_ptr<const ForceLaw>>;

}  // namespace rigid_body_sim
