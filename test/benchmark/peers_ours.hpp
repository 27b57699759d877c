#pragma once

#include "benchmark/peers.hpp"

namespace rigid_body_sim::peers {

struct Contender {
  std::string name;
  std::vector<Run> runs;
};

/// The attitude at the end, by the exact rotation or Taylor series in long double.
Quaternion4 truthOf(const Problem& problem);

/// auto, and every integrator of the catalogue that supports what acts.
std::vector<Contender> ourRuns(const Problem& problem);

/// [s] of processor time that auto takes before the start, at a tolerance of 1e-6: it may try the
/// integrators.
double timeToChoose(const Problem& problem);

/// [s] of processor time of so many steps of h with these bodies in one world, all of them read at
/// every tenth step.
double ourCrowd(const std::vector<Problem>& bodies, const std::string& integrator, double h,
                int steps);

/// The attitude of a single one after these steps.
Quaternion4 ourEnd(const Problem& problem, const std::string& integrator, double h, int steps);

}  // namespace rigid_body_sim::peers
