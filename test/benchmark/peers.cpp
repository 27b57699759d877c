#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "benchmark/peers_cases.hpp"
#include "benchmark/peers_ours.hpp"

// Processor time to reach an attitude error, case by case: the engines found on this machine
// against ours, in one run. odeint is compiled for this very processor, ours as it is shipped, the
// others as Debian packages them. Making a world is not counted.
//   A  a free body, 100 s
//   B  the same, spun about its unstable axis, 60 s
//   C  a box under gravity and a constant world force at a body point, 10 s
//   D  the box hung on a spring at a body point, 10 s
//   E  a body with three wheels whose torques change every half second, 10 s
//   F  the same that tumbles, with the spin of A

namespace rigid_body_sim::peers {

namespace {

/// The cheapest run whose error stays within the target; null when there is none.
const Run* cheapest(const std::vector<Run>& runs, const Problem& problem, double target) {
  const Run* best = nullptr;
  for (const Run& run : runs)
    if (errorOf(run, problem) <= target && (!best || run.seconds < best->seconds)) best = &run;
  return best;
}

/// How a peer fares against ours, over all cases.
struct Score {
  std::string name;
  int ahead = 0;  ///< targets at which ours is ahead, or the only one to get there
  std::vector<std::string> losses;
};

void count(const Run* ours, const Run* peer, const std::string& what, Score& score) {
  if (ours && (!peer || ours->seconds < peer->seconds)) {
    ++score.ahead;
  } else if (peer) {
    std::ostringstream loss;
    loss.precision(2);
    loss << what << (ours ? " by " : ", which ours does not reach");
    if (ours) loss << ours->seconds / peer->seconds;
    score.losses.push_back(loss.str());
  }
}

/// The times of a contender; with peers of ours, how many times as long as our cheapest.
void printTimes(const Contender& contender, const Problem& problem, const std::vector<Run>* ours) {
  std::printf("%-20s", contender.name.c_str());
  for (double target : kTargets) {
    const Run* run = cheapest(contender.runs, problem, target);
    const Run* our = ours ? cheapest(*ours, problem, target) : nullptr;
    if (!run)
      std::printf(" %20s", "not reached");
    else if (our)
      std::printf(" %10.1f %8.3gx", 1e6 * run->seconds, run->seconds / our->seconds);
    else
      std::printf(" %10.1f %9s", 1e6 * run->seconds, "");
  }
  std::printf("\n");
}

void printBest(const Contender& contender, const Problem& problem) {
  std::printf("%s:", contender.name.c_str());
  double least = INFINITY;
  for (const Run& run : contender.runs) least = std::fmin(least, errorOf(run, problem));
  for (double target : kTargets)
    if (const Run* run = cheapest(contender.runs, problem, target))
      std::printf(" %.0e %s;", target, run->setting.c_str());
  std::printf(" least error %.1e rad\n", least);
}

void compare(const Problem& problem, std::vector<Score>& scores) {
  std::vector<Contender> peers;
  for (const Engine& engine : engines()) peers.push_back({engine.name, engine.runs(problem)});
  const std::vector<Contender> ours = ourRuns(problem);
  std::vector<Run> all_ours;
  for (const Contender& row : ours)
    all_ours.insert(all_ours.end(), row.runs.begin(), row.runs.end());

  std::printf("\ncase %s: processor time [us], and how many times that of our cheapest\n%-20s",
              problem.name, "attitude error [rad]");
  for (double target : kTargets) std::printf(" %10.0e %9s", target, "");
  std::printf("\n");
  for (const Contender& peer : peers) printTimes(peer, problem, &all_ours);
  for (const Contender& row : ours) printTimes(row, problem, nullptr);
  for (const Contender& peer : peers) printBest(peer, problem);
  printBest({"ours", all_ours}, problem);
  std::printf("auto takes %.1f us before the start, which are not counted\n",
              1e6 * timeToChoose(problem));

  for (std::size_t i = 0; i < peers.size(); ++i)
    for (double target : kTargets)
      count(cheapest(all_ours, problem, target), cheapest(peers[i].runs, problem, target),
            label(problem.name, "at", target), scores[i]);
  std::fflush(stdout);
}

/// Those that are named, or all.
std::vector<Case> wantedCases(const std::vector<std::string>& names) {
  if (names.empty()) return cases();
  std::vector<Case> wanted;
  for (const std::string& name : names) {
    const auto found = std::find_if(cases().begin(), cases().end(),
                                    [&](const Case& each) { return each.name == name; });
    if (found == cases().end())
      throw std::invalid_argument("no case " + name + "; there are those from " +
                                  cases().front().name + " to " + cases().back().name);
    wanted.push_back(*found);
  }
  return wanted;
}

void run(const std::vector<Case>& wanted) {
  std::sort(engines().begin(), engines().end(),
            [](const Engine& a, const Engine& b) { return std::string(a.name) < b.name; });
  std::vector<Score> scores;
  for (const Engine& engine : engines()) scores.push_back({engine.name, 0, {}});
  for (const Case& each : wanted) compare(each.make(), scores);
  std::printf("\n");
  for (const Score& score : scores) {
    std::printf("ahead of %s at %d of %zu;", score.name.c_str(), score.ahead,
                wanted.size() * kTargets.size());
    for (const std::string& loss : score.losses) std::printf(" behind in %s;", loss.c_str());
    std::printf("\n");
  }
}

}  // namespace
}  // namespace rigid_body_sim::peers

/// Of all cases, or of those whose names are the arguments.
int main(int argc, char** argv) {
  using namespace rigid_body_sim::peers;
  std::vector<Case> wanted;
  try {
    wanted = wantedCases({argv + 1, argv + argc});
  } catch (const std::invalid_argument& fault) {
    std::fprintf(stderr, "benchmark_peers: %s\n", fault.what());
    return 2;
  }
  run(wanted);
}
