#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <rigid_body_sim/dynamics/drag.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/packs/pack_block.hpp"
#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {

/// What moves a body by itself in the same way from step to step: an integrator, and what is held.
struct SteadyMotion {
  const Body* body;
  const Method* method;
  double max_turn;                   ///< |ω| h [rad] up to which a step is not divided
  Vector3d weight_W;                 ///< [N] of gravity
  const HeldWrench* held = nullptr;  ///< null: nothing
  const Drag* drag = nullptr;        ///< null: none
  bool wrenches_current = false;     ///< see Workspace
  double magnification = 0;          ///< see Stepper
};

/// Whether bodies may be stepped by this integrator in packs.
bool hasPackSteps(const Method& method);

/// Whether bodies on which this is held may be stepped in packs: one force at a point of the body
/// at most, none at a point of the world.
bool hasPackSteps(const HeldWrench& held);

/// The pack steps of the integrator with which a body moves; none where there are none.
std::optional<PackKind> packKindOf(const SteadyMotion& motion);

/// Bodies by themselves that an integrator steps many at a time, with the bits of one by one. Only
/// those are here of which it is certain, for the next steps, that their motion stays finite and
/// slow enough for the integrator: no step of theirs fails. Everything else about them stays with
/// their groups, which are left behind meanwhile.
class Packs {
 public:
  /// Steps that are certain from an add() or a review() on.
  static constexpr std::int64_t kCertainSteps = 64;

  Packs() = default;

  /// None of so many bodies are here; time_step [s]; stepped by so many threads at most.
  Packs(std::size_t bodies, double time_step, int threads)
      : time_step_(time_step), threads_(threads), places_(bodies), is_used_(true) {}

  /// False where no body can be here, as the world's integrator or laws do not allow it.
  bool isUsed() const { return is_used_; }

  std::size_t size() const { return size_; }
  bool holds(std::size_t body) const { return size_ > 0 && places_[body].lane != kNowhere; }

  /// The bodies here, in no order.
  std::vector<std::size_t> bodies() const;

  /// Bodies that may be fit for a pack, to be looked at before the next step.
  void offer(std::size_t body) {
    if (is_used_) offered_.push_back(body);
  }
  bool hasOffers() const { return !offered_.empty(); }
  std::vector<std::size_t> takeOffers();

  /// Takes a body over at its present state, after so many steps of the run. next_event: its next
  /// event [s]. Returns whether its motion is certain; where not, nothing has changed.
  bool add(std::size_t body, const SteadyMotion& motion, const BodyState& state, double next_event,
           std::int64_t steps);

  /// What a body has become here.
  struct Stepped {
    BodyState state;
    std::int64_t evaluations;  ///< here
    bool wrenches_current;
    double magnification;
  };
  Stepped steppedTo(std::size_t body, std::int64_t steps) const;
  void remove(std::size_t body);

  BodyState state(std::size_t body) const;

  /// Writes the states of the bodies here among those of all bodies, by as many threads.
  void copyTo(std::vector<BodyState>& states) const;

  /// After so many steps of the run takes `count` more, at most certainSteps(), with all bodies.
  /// read: where their states are then copied to, among those of all bodies, while they are in the
  /// nearest cache; or null.
  void advance(std::int64_t steps, std::int64_t count, std::vector<BodyState>* read);
  std::int64_t certainSteps() const { return certain_steps_; }

  /// To be called when no more steps are certain: returns the bodies of which none is, to be
  /// removed.
  std::vector<std::size_t> review();

  /// [s] No event of a body here is before.
  double nextEvent() const { return next_event_; }

  /// The bodies with an event up to t [s].
  std::vector<std::size_t> withEventBy(double t);

  /// Of all bodies here, after so many steps of the run; see Simulation.
  std::int64_t evaluations(std::int64_t steps) const;
  double magnification() const;

 private:
  static constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

  struct Place {
    std::uint32_t shelf = 0;
    std::uint32_t lane = kNowhere;
  };
  struct Lane {
    std::int64_t since;     // steps of the run
    bool wrenches_current;  // then
    double next_event;      // [s]
  };
  /// Bodies that are stepped by the same function.
  struct Shelf {
    PackKind kind;
    PackLoad load;
    const Method* method;
    std::vector<PackBlock> blocks;
    std::vector<PushBlock> pushes;    // block by block; none without load
    std::vector<std::size_t> bodies;  // lane by lane
    std::vector<Lane> lanes;
  };

  static void copyLanes(const Shelf& shelf, std::size_t first, std::size_t end,
                        std::vector<BodyState>& states);
  void addNoTorque(const Place& place);
  void putLast(std::size_t lane, Shelf& shelf);
  Shelf& shelfOf(PackKind kind, PackLoad load, const Method& method, std::uint32_t& index);
  static std::int64_t evaluationsOf(const Shelf& shelf, const Lane& lane, std::int64_t steps);

  double time_step_ = 0;
  int threads_ = 1;
  std::vector<Shelf> shelves_;
  std::vector<Place> places_;  // body by body
  std::vector<std::size_t> offered_;
  std::vector<std::size_t> new_;  // bodies without a step here
  std::size_t size_ = 0;
  std::int64_t certain_steps_ = kCertainSteps;
  double next_event_ = std::numeric_limits<double>::infinity();
  bool is_used_ = false;
  /// Every second time all bodies are gone through from the last to the first: those that were
  /// stepped last are still in the cache.
  bool is_backward_ = false;
};

}  // namespace rigid_body_sim
