#include "support/reference_contact_law.hpp"

#include <cmath>

namespace rigid_body_sim::contact_reference {

namespace {

Real oddPower(Real depth, Real p) {
  const Real size = std::abs(depth);
  if (p == 1) return depth;
  return p == 1.5L ? depth * std::sqrt(size) : std::copysign(std::pow(size, p), depth);
}

}  // namespace

Mat Pose::R() const { return q.toRotationMatrix(); }

Vec Pose::velocityAt(const Vec& arm_W) const { return v + Vec(R() * w).cross(arm_W); }

Slider::Slider(const Vec& s, const Vec& v, Real k, Real c, Real cap, bool slips)
    : pull(-(k * s + c * v)), rate(v), excess(pull.norm() - cap) {
  const Real size = pull.norm();
  if (!slips || size == 0) return;
  rate = v + (1 - cap / size) / c * pull;
  pull *= cap / size;
}

Action::Action(const Element& e, const Mode& mode, const std::vector<Pose>& at) : look(e.look(at)) {
  for (std::size_t j = 0; j < look.count; ++j) {
    if (mode.touches[j] && !mode.clipped[j])
      normal[j] = e.law.k * oddPower(look.depth[j], e.law.p) * (1 + e.law.d * look.rate[j]);
    total += normal[j];
  }
  placeCenter();
  for (std::size_t j = 0; j < look.count; ++j)
    spread += normal[j] * (look.arm_a[j] - center_a).norm();
  Vec u = at[e.a].velocityAt(center_a);
  if (e.b != Element::kNone) u -= at[e.b].velocityAt(center_b);
  slip = u - look.n * look.n.dot(u);
  spin = look.n.dot(Vec(at[e.a].R() * at[e.a].w));
}

void Action::placeCenter() {
  if (total == 0) {
    center_a = look.arm_a[0];
    center_b = look.arm_b[0];
    return;
  }
  for (std::size_t j = 0; j < look.count; ++j) {
    center_a += normal[j] / total * look.arm_a[j];
    center_b += normal[j] / total * look.arm_b[j];
  }
}

Real springOf(const Element& e) { return e.law.mu * e.reduced_mass * 9.80665L / e.law.b; }

Real damperOf(const Element& e) { return 0.4L * std::sqrt(springOf(e) * e.reduced_mass); }

Slider slide(const Element& e, const Mode& m, const Action& act, const Real* own) {
  return {{own[0], own[1], own[2]}, act.slip, springOf(e), damperOf(e),
          e.law.mu * act.total,     m.slips};
}

Slider spin(const Element& e, const Mode& m, const Action& act, const Real* own) {
  const Real area = e.rim_radius * e.rim_radius;
  return {{own[3], 0, 0},     {act.spin, 0, 0},      area * springOf(e),
          area * damperOf(e), e.law.mu * act.spread, m.spins};
}

Guards guardsOf(const Element& e, const Mode& m, const Real* own, const std::vector<Pose>& at) {
  const Action act(e, m, at);
  Guards guards;
  guards.fill(1);
  for (std::size_t j = 0; j < act.look.count; ++j) {
    guards[j] = m.touches[j] ? act.look.depth[j] : -act.look.depth[j];
    const Real push = 1 + e.law.d * act.look.rate[j];
    if (m.touches[j]) guards[4 + j] = m.clipped[j] ? -push : push;
  }
  if (!m.touching() || e.law.mu == 0) return guards;
  const Real margin = 1e-15L * e.reduced_mass;
  const Real over = slide(e, m, act, own).excess;
  guards[8] = m.slips ? over : margin - over;
  if (e.rim_radius == 0) return guards;
  const Real turned = spin(e, m, act, own).excess;
  guards[9] = m.spins ? turned : margin * e.rim_radius - turned;
  return guards;
}

bool flip(Mode& m, std::size_t guard) {
  if (guard == 8) m.slips = !m.slips;
  if (guard == 9) m.spins = !m.spins;
  if (guard >= 4 && guard < 8) m.clipped[guard - 4] = !m.clipped[guard - 4];
  if (guard >= 4) return false;
  const bool touched = m.touching();
  m.touches[guard] = !m.touches[guard];
  m.clipped[guard] = false;
  if (touched == m.touching()) return false;
  m.slips = m.spins = false;
  return true;
}

}  // namespace rigid_body_sim::contact_reference
