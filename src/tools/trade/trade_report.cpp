#include "tools/trade/trade_report.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

bool contains(const std::vector<Setting>& settings, const Setting& wanted) {
  return std::any_of(settings.begin(), settings.end(), [&](const Setting& s) {
    return s.integrator == wanted.integrator && s.time_step == wanted.time_step &&
           s.tolerance == wanted.tolerance;
  });
}

/// [rad, relative] What settings are judged by: no tighter than the reference can tell.
double budgetOf(const Trade& trade) {
  return std::max(trade.error_budget, 2 * trade.reference.doubt.bounded());
}

/// What differs between the settings of an integrator.
const char* varied(const Trade& trade) {
  const bool tolerances = !trade.settings.empty() && trade.settings.front().tolerance > 0;
  return tolerances ? "tolerance" : "time step";
}

/// An error, with ~ where the reference's own could make it wrong by more than a factor of two.
std::string errorText(double error, double doubt) {
  return formatted(" %9.1e%c", error, error <= 2 * doubt ? '~' : ' ');
}

}  // namespace

TradeCsv::TradeCsv(const std::string& path, bool tolerances)
    : path_(path), tolerances_(tolerances), file_(std::fopen(path.c_str(), "w")) {
  if (!file_) throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
  std::fputs(
      "integrator,time_step,attitude_error,position_error,energy_error,angular_momentum_error,"
      "cpu_ns_per_sim_s,force_evaluations",
      file_);
  std::fputs(tolerances_ ? ",tolerance\n" : "\n", file_);
  flush();
}

TradeCsv::~TradeCsv() { std::fclose(file_); }

void TradeCsv::write(const Setting& s) {
  std::fprintf(file_, "%s,%s,%.6e,%.6e,%.6e,%.6e,%.6e,%lld", s.integrator.c_str(),
               shortest(s.time_step).c_str(), s.errors.attitude, s.errors.position, s.errors.energy,
               s.errors.angular_momentum, s.cpu_ns_per_sim_s,
               static_cast<long long>(s.force_evaluations));
  if (tolerances_) std::fprintf(file_, ",%s", shortest(s.tolerance).c_str());
  std::fputc('\n', file_);
  flush();
}

void TradeCsv::flush() {
  if (std::fflush(file_) != 0 || std::ferror(file_))
    throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

bool isPresent(const Setting& setting, const SolverOptions& present) {
  return setting.integrator == present.integrator && setting.time_step == present.time_step &&
         (setting.tolerance == 0 || setting.tolerance == present.tolerance);
}

/// Where a motion magnifies errors so much that its end cannot be known.
std::string chaosText(const Reference& reference) {
  if (!(reference.known_until < reference.duration)) return "";
  return formatted(
      "the motion is known to the error budget until %.4g s: from then on errors are magnified too "
      "much; measure what comes before with --duration %.4g\n",
      reference.known_until, reference.known_until);
}

std::string referenceText(const Reference& reference) {
  const double doubt = reference.doubt.bounded();
  const int digits = doubt > 0 ? std::max(0, static_cast<int>(-std::log10(doubt))) : 15;
  return formatted("reference: %s; %s agrees to %.1e rad and to %.1e of the path: %d digits\n",
                   reference.method.c_str(), reference.check.c_str(), reference.doubt.attitude,
                   reference.doubt.position, digits) +
         chaosText(reference);
}

std::string tableText(const Trade& trade) {
  const Errors& doubt = trade.reference.doubt;
  const std::vector<Setting> front = paretoFront(trade.settings, trade.reference);
  std::string table =
      formatted("   %-19s %12s  %9s  %9s  %9s  %9s  %11s %12s\n", "integrator", varied(trade),
                "attitude", "position", "energy", "ang. mom.", "CPU us/s", "evaluations");
  for (const Setting& s : trade.settings) {
    table +=
        formatted("%c%c ", contains(front, s) ? '*' : ' ', isPresent(s, trade.present) ? '<' : ' ');
    table += formatted("%-19s %12.6g ", s.integrator.c_str(),
                       s.tolerance > 0 ? s.tolerance : s.time_step);
    table += errorText(s.errors.attitude, doubt.attitude) +
             errorText(s.errors.position, doubt.position) +
             errorText(s.errors.energy, doubt.energy) +
             errorText(s.errors.angular_momentum, doubt.angular_momentum);
    table += formatted(" %12.4g %12lld\n", 1e-3 * s.cpu_ns_per_sim_s,
                       static_cast<long long>(s.force_evaluations));
  }
  return table +
         "* on the Pareto front   < what the scene says now   ~ less than twice what the reference "
         "may err by\n";
}

const Setting* recommended(const Trade& trade) {
  return cheapestWithin(trade.settings, trade.reference, budgetOf(trade), trade.present);
}

std::string adviceText(const Trade& trade) {
  std::string advice;
  const double budget = budgetOf(trade);
  if (budget > trade.error_budget)
    advice =
        formatted("the reference is known to %.2g only, too little for an error budget of %.3g\n",
                  trade.reference.doubt.bounded(), trade.error_budget);
  const Setting* best = recommended(trade);
  if (!best) return advice + formatted("no setting stays within %.2g\n", budget);
  advice += formatted(
      "least work within %.3g (counted, not timed), %.4g us of CPU per simulated "
      "second:\n",
      budget, 1e-3 * best->cpu_ns_per_sim_s);
  advice += "integrator: " + best->integrator + "\n";
  advice += "time_step: " + shortest(best->time_step) + "\n";
  if (best->tolerance > 0) advice += "tolerance: " + shortest(best->tolerance) + "\n";
  if (isPresent(*best, trade.present)) return advice + "That is what the scene says now.\n";
  advice += "Replace these keys of the scene";
  if (best->integrator != "auto" && trade.present.tolerance_stated)
    advice += " and delete its key tolerance, which goes with auto only";
  advice += "; trade --write does it.\n";
  advice +=
      "In a node, messages are applied at time steps: a shorter step reacts sooner, costs more "
      "and is at least as accurate.\n";
  return advice;
}

}  // namespace rigid_body_sim
