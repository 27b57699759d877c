#include <stdexcept>

#include <rigid_body_sim/dynamics/catalogue.hpp>

namespace rigid_body_sim {

const std::vector<Method>& catalogue() {
  // name, order, evaluations, reversible, bounded energy, keeps L
  static const std::vector<Method> rows{
      {"semi_implicit_euler", 1, 1, false, false, true, semiImplicitEulerStep},
      {"strang", 2, 1, true, true, true, strangStep},
      {"rk4", 4, 4, false, false, false, rk4Step},
  };
  return rows;
}

const Method& methodNamed(const std::string& name) {
  std::string known;
  for (const Method& row : catalogue()) {
    if (name == row.name) return row;
    known += std::string(known.empty() ? "" : ", ") + row.name;
  }
  throw std::invalid_argument("integrator must be one of auto, " + known + ", got '" + name + "'");
}

}  // namespace rigid_body_sim
