#pragma once

#include <memory>
#include <set>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/wrenches/wrench_schedule.hpp"

namespace rigid_body_sim {

/// Bodies that act on one another, with the laws between them.
struct CoupledBodies {
  std::vector<std::size_t> members;  ///< indices in the world, ascending
  std::vector<std::size_t> laws;     ///< indices in World::laws, ascending
  std::vector<std::size_t>
      waiting;  ///< contacts and tethers between them that do not act, likewise

  bool operator==(const CoupledBodies& other) const {
    return members == other.members && laws == other.laws && waiting == other.waiting;
  }
};

/// Indices, ascending.
std::vector<std::size_t> movingBodies(const World& world);

/// The laws of a world: where their own states lie, and which act on each body.
class LawTable {
 public:
  explicit LawTable(const World& world);

  /// Of a law's own states, in State::laws.
  std::size_t firstState(std::size_t law) const { return constant_->first_state[law]; }
  std::size_t stateCount() const { return constant_->state_count; }

  /// Laws of which a body is a member; of those that need it to be near another one
  /// (ForceLaw::touchRadius), the ones put by setCandidates.
  const std::vector<std::size_t>& of(std::size_t body) const {
    return ofPairs().empty() ? constant_->of_body[body] : of_body_[body];
  }

  /// Laws that need two bodies to be near each other, ascending; all, and
  /// those of bodies that may come near each other for now.
  const std::vector<std::size_t>& ofPairs() const { return constant_->of_pairs; }
  const std::vector<std::size_t>& candidates() const { return candidates_; }
  void setCandidates(const World& world, const std::vector<std::size_t>& laws);

  /// Other laws with guards, that may begin to act while they do not.
  const std::vector<std::size_t>& guarded() const { return constant_->guarded; }

  /// Those of them that are contacts.
  const std::vector<std::size_t>& contacts() const { return constant_->contacts; }

  /// Laws that act in some places and not in others: contacts and tethers.
  const std::vector<std::size_t>& oneSided() const { return constant_->one_sided; }

  /// As the laws start.
  std::vector<double> start(const World& world) const;

 private:
  struct Constant {
    std::vector<std::size_t> first_state;  // of each law
    std::size_t state_count = 0;
    std::vector<std::vector<std::size_t>> of_body;  // without laws of pairs
    std::vector<std::size_t> guarded, contacts, one_sided, of_pairs;
  };
  static Constant constantOf(const World& world);

  std::shared_ptr<const Constant> constant_;
  std::vector<std::vector<std::size_t>> of_body_;  // with candidates; empty without laws of pairs
  std::vector<std::size_t> candidates_;
};

/// Groups those bodies that the laws and wrenches which act now link with one another. bodies: all
/// that move, or some that nothing else is linked with. law_states: State::laws. near: laws that
/// may begin to act at any moment; they link, too, where their bodies have to be integrated anyway.
std::vector<CoupledBodies> coupledBodies(const World& world, const LawTable& laws,
                                         const std::vector<double>& law_states,
                                         const std::vector<WrenchSchedule>& schedules,
                                         const std::vector<std::size_t>& bodies,
                                         const std::set<std::size_t>& near = {});

/// What contacts and tethers that do not act, and actuators, will need of an integrator that
/// follows the group (Need).
unsigned needsAhead(const World& world, const CoupledBodies& group,
                    const std::vector<WrenchSchedule>& schedules);

/// What an integrator must support to advance the group (Need); needsAhead counts where it has to
/// be integrated anyway.
unsigned needsOf(const World& world, const CoupledBodies& group,
                 const std::vector<WrenchSchedule>& schedules);

/// Throws std::invalid_argument, naming the body, where the world's integrator is unknown or does
/// not support what acts, now or later. For a world whose integrator is not auto.
void requireSupport(const World& world);

}  // namespace rigid_body_sim
