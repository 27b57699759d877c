#include "dynamics/run/cubic_between.hpp"

namespace rigid_body_sim {

void CubicBetween::at(double share, SystemState& states) const {
  const double s2 = share * share, s3 = s2 * share;
  const double of_gap = 3 * s2 - 2 * s3;
  const double of_first = h_ * (s3 - 2 * s2 + share), of_last = h_ * (s3 - s2);
  const std::size_t n = a_.bodies.size();
  states.bodies.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const BodyState &a = a_.bodies[i], &b = b_.bodies[i];
    const BodyStateDot& first = stages_.dots[i];
    const BodyStateDot& last = stages_.dots[stages_.dots.size() - n + i];
    BodyState& state = states.bodies[i];
    state = a;
    state.x_low_W += of_gap * ((b.x_W - a.x_W) + (b.x_low_W - a.x_low_W)) +
                     of_first * first.x_dot_W + of_last * last.x_dot_W;
    state.q_WP.coeffs() += of_gap * (b.q_WP.coeffs() - a.q_WP.coeffs()) + of_first * first.q_dot +
                           of_last * last.q_dot;
    state.q_WP.normalize();
    state.p_W += of_gap * (b.p_W - a.p_W) + of_first * first.p_dot_W + of_last * last.p_dot_W;
    state.L_P += of_gap * (b.L_P - a.L_P) + of_first * first.L_dot_P + of_last * last.L_dot_P;
    state.L_W = rotate(state.q_WP, state.L_P);
  }
  states.laws = b_.laws;
  if (stages_.law_dots.empty()) return;
  const double* first = stages_.law_dots.data();
  const double* last = first + (stages_.law_dots.size() - b_.laws.size());
  for (std::size_t k = 0; k < b_.laws.size(); ++k)
    states.laws[k] =
        a_.laws[k] + of_gap * (b_.laws[k] - a_.laws[k]) + of_first * first[k] + of_last * last[k];
}

}  // namespace rigid_body_sim
