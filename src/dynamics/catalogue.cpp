#include <stdexcept>

#include <rigid_body_sim/dynamics/catalogue.hpp>

namespace rigid_body_sim {

const std::vector<Method>& catalogue() {
  // The longest turns are where the energy error of a free body passes about 1e-2 (strang and its
  // compositions) or the method leaves its order; measured: doc/extremes.md.
  // name, order, free order, evaluations, reversible, bounded energy, keeps L, most turn, step
  static const std::vector<Method> rows{
      {"semi_implicit_euler", 1, 1, 1, false, false, true, 1.0, semiImplicitEulerStep},
      {"strang", 2, 2, 1, true, true, true, 0.8, strangStep},
      {"magnus4", 2, 4, 1, false, false, true, 0.4, magnus4Step},
      {"rk4", 4, 4, 4, false, false, false, 0.4, rk4Step},
      {"kahan_li8", 8, 8, 17, true, true, true, 0.8, kahanLi8Step},
      {"dop853", 8, 8, 12, false, false, false, 1.6, dop853Step},
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
