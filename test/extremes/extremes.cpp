#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>

#include "cell_lines.hpp"
#include "sections.hpp"

// Prints the map of the extremes as CSV, a line a cell: scripts/extremes makes a document of it.
// usage: extremes map [SECTION] | growth ROW STEPS | day ROW

namespace rigid_body_sim::extremes {
namespace {

const Names kFreeIntegrators{"auto", "taylor",       "semi_implicit_euler", "strang", "magnus4",
                             "rk4",  "blanes_moan6", "kahan_li8",           "dop853"};
const Names kLawIntegrators{"auto", "semi_implicit_euler", "strang",    "magnus4",
                            "rk4",  "blanes_moan6",        "kahan_li8", "dop853"};
const Names kFewIntegrators{"auto", "strang", "rk4", "dop853"};

using Section = std::function<Cells()>;

/// All sections by name; those that name no integrator run by all that support what they hold.
std::vector<std::pair<std::string, Section>> sections() {
  std::vector<std::pair<std::string, Section>> named;
  const auto add = [&](const std::string& name, const std::function<Cells(const Names&)>& section,
                       const Names& integrators) {
    named.emplace_back(name, [section, integrators] { return section(integrators); });
  };
  for (const auto& [name, section] : oneBodySections()) add(name, section, kFreeIntegrators);
  add(
      "spring", [](const Names& integrators) { return springs(integrators); }, kLawIntegrators);
  named.emplace_back("tolerance", tolerances);
  named.emplace_back("crowd", [] { return crowds(kFewIntegrators, 100000); });
  named.emplace_back("schedule", [] { return schedules(kFewIntegrators, 100000); });
  named.emplace_back("contact_stiffness", contactStiffnesses);
  named.emplace_back("contact_mass", contactMasses);
  named.emplace_back("contact_speed", contactSpeeds);
  named.emplace_back("contact_drop", contactDrops);
  named.emplace_back("contact_friction", contactFrictions);
  named.emplace_back("contact_start", [] { return contactStarts(); });
  named.emplace_back("contact_many", [] { return contactCrowds(1000); });
  named.emplace_back("refused", refusals);
  for (const std::string& integrator : kFreeIntegrators)
    named.emplace_back("growth", [integrator] { return growth(integrator, 1000000); });
  return named;
}

/// One section, or all.
bool printMap(const std::string& wanted) {
  bool complete = true;
  for (const auto& [name, section] : sections())
    if (wanted.empty() || name == wanted) complete &= print(section());
  return complete;
}

/// [KiB] Memory in use, as the kernel counts it.
long residentMemory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word && word != "VmRSS:") {
  }
  long size = 0;
  status >> size;
  return size;
}

/// The OSRF box (complex) tumbles for 24 hours at 1 kHz.
bool printDay(const std::string& integrator) {
  test::Bench bench = test::complexBox();
  bench.world.g_W.setZero();
  Simulation simulation = bench.simulation(integrator, 1e-3);
  for (int i = 0; i < 1000; ++i) simulation.step();
  const long before = residentMemory();
  Cells cells;
  for (int hour = 1; hour <= 24; ++hour) {
    while (simulation.steps() < hour * 3600000LL) simulation.step();
    if (hour != 1 && hour % 6 != 0) continue;
    Cell cell{"day", std::to_string(hour), integrator};
    compare(bench, simulation.state(), freeEnds(bench, simulation.time(), Truth::closed_form),
            cell);
    cells.push_back(cell);
  }
  const bool complete = print(cells);
  std::printf("memory,\"%s\",\"%s\",%ld,%ld,0,0,,\n", integrator.c_str(), integrator.c_str(),
              before, residentMemory());
  return complete;
}

}  // namespace
}  // namespace rigid_body_sim::extremes

int main(int argc, char** argv) {
  using namespace rigid_body_sim::extremes;
  const std::string what = argc > 1 ? argv[1] : "";
  try {
    if (what == "map" && argc <= 3) return printMap(argc == 3 ? argv[2] : "") ? 0 : 1;
    if (what == "growth" && argc == 4) return print(growth(argv[2], std::atoll(argv[3]))) ? 0 : 1;
    if (what == "day" && argc == 3) return printDay(argv[2]) ? 0 : 1;
  } catch (const std::exception& failed) {
    std::cerr << failed.what() << "\n";
    return 1;
  }
  std::cerr << "usage: extremes map [SECTION] | growth ROW STEPS | day ROW\n";
  return 2;
}
