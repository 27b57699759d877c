#pragma once

#include <cstddef>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// The bodies of a world that are shown, by their indices, ascending.
class ShownBodies {
 public:
  /// Those that have come in or left.
  struct Changes {
    std::vector<std::size_t> entered, left;
    bool any() const { return !entered.empty() || !left.empty(); }
  };

  /// Takes a body in; gives it back. To be followed by list.
  void add(std::size_t body);
  void remove(std::size_t body);

  /// Finds which of them move and are present.
  void list(const World& world);

  /// The same where the world has changed since the last call. Returns who has come in or left.
  Changes follow(const Simulation& simulation);

  const std::vector<std::size_t>& present() const { return present_; }
  const std::vector<std::size_t>& moving() const { return moving_; }  ///< of those present

 private:
  std::vector<std::size_t> all_, present_, moving_;
  std::size_t followed_changes_ = 0;  // Simulation::worldChanges
};

}  // namespace rigid_body_sim
