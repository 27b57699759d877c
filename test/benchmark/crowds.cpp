#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

#include "benchmark/peers_ours.hpp"

// Many free bodies under gravity in one world: millions of steps of one body in a second of
// processor time, of the engines found on this machine and of ours, in one run; and for each engine
// how many times as long it takes as ours to be as accurate as it is at its step.
// usage: benchmark_crowds [BODIES [STEP]]    default 10000 bodies, 1e-3 s

namespace rigid_body_sim::peers {
namespace {

constexpr double kDuration = 10;     // [s] after which errors are compared
constexpr int kSteps = 200;          // that are timed
constexpr double kRounding = 1e-11;  // [rad] of so many steps: smaller errors are as good
const char* const kOurs[] = {"semi_implicit_euler", "strang", "magnus4", "rk4"};

/// Boxes of 1 kg of any edges from 0.3 to 1 m, turning at 3 rad/s.
std::vector<Problem> bodies(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> edge(0.3, 1), any(-1, 1);
  std::vector<Problem> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = std::pow(edge(random), 2), b = std::pow(edge(random), 2),
                 c = std::pow(edge(random), 2);
    Problem body{"box", 1, {(b + c) / 12, (a + c) / 12, (a + b) / 12}, {}};
    for (double& w : body.start.w_P) w = any(random);
    const auto& w = body.start.w_P;
    const double scale = 3 / std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    for (double& each : body.start.w_P) each *= scale;
    for (double& v : body.start.v_W) v = any(random);
    body.start.x_W[0] = static_cast<double>(i);  // engines look for contacts
    body.g_W = {0, 0, -9.81};
    body.duration = kDuration;
    all.push_back(body);
  }
  return all;
}

/// [rad] The worst attitude at the end of some bodies, each by end(problem, h, steps).
template <class End>
double worstError(const std::vector<Problem>& some, double h, const End& end) {
  double worst = 0;
  const int steps = static_cast<int>(std::lround(kDuration / h));
  for (const Problem& problem : some) {
    const double error = errorOf({"", 0, end(problem, h, steps)}, problem);
    worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
  }
  return worst;
}

/// One of ours at one step.
struct Ours {
  std::string integrator;
  double h;
  double error;    // [rad]
  double seconds;  // of processor time of a body and simulated second
};

std::vector<Ours> ladder(const std::vector<Problem>& all, const std::vector<Problem>& some,
                         double h) {
  std::vector<Ours> ours;
  for (const char* integrator : kOurs) {
    const double seconds = ourCrowd(all, integrator, h, kSteps) / kSteps;
    for (const double longer : {1., 2., 5., 10., 20., 50.}) {
      const auto end = [&](const Problem& p, double step, int n) {
        return ourEnd(p, integrator, step, n);
      };
      ours.push_back({integrator, longer * h, worstError(some, longer * h, end),
                      seconds / (longer * h) / static_cast<double>(all.size())});
      if (longer == 1)
        std::printf("%-22s %10.3g %14.1e\n", integrator,
                    1e-6 * static_cast<double>(all.size()) / seconds, ours.back().error);
    }
    std::fflush(stdout);
  }
  return ours;
}

void compare(const Crowd& crowd, const Stepper& stepper, const std::vector<Problem>& all,
             const std::vector<Problem>& some, double h, const std::vector<Ours>& ours) {
  const double of_step = crowd.seconds(all, h, kSteps) / kSteps;
  const double error = worstError(
      some, h, [&](const Problem& p, double step, int n) { return stepper.end(p, step, n).q; });
  const double seconds = of_step / h / static_cast<double>(all.size());
  const Ours* best = nullptr;
  for (const Ours& each : ours)
    if (each.error <= std::max(error, kRounding) && (!best || each.seconds < best->seconds))
      best = &each;
  std::printf("%-22s %10.3g %14.1e", crowd.name, 1e-6 * static_cast<double>(all.size()) / of_step,
              error);
  if (best)
    std::printf(" %10.1f times as long as %s at %g s (%.1e rad)", seconds / best->seconds,
                best->integrator.c_str(), best->h, best->error);
  std::printf("\n");
  std::fflush(stdout);
}

void run(std::size_t count, double h) {
  const std::vector<Problem> all = bodies(count);
  std::vector<Problem> some(all.begin(), all.begin() + std::min<std::ptrdiff_t>(8, all.size()));
  for (Problem& problem : some) problem.truth = truthOf(problem);
  std::printf("%zu bodies, steps of %g s; ours read at every tenth step\n", count, h);
  std::printf("%-22s %10s %14s\n", "", "1e6 / s", "error [rad]");
  const std::vector<Ours> ours = ladder(all, some, h);
  for (const Engine& engine : engines())
    for (const Crowd& crowd : engine.crowds)
      for (const Stepper& stepper : engine.steppers)
        if (std::string(stepper.name) == crowd.name) compare(crowd, stepper, all, some, h, ours);
}

}  // namespace
}  // namespace rigid_body_sim::peers

int main(int argc, char** argv) {
  rigid_body_sim::peers::run(argc > 1 ? static_cast<std::size_t>(std::atoll(argv[1])) : 10000,
                             argc > 2 ? std::atof(argv[2]) : 1e-3);
}
