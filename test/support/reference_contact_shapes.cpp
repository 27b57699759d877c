#include "support/reference_contact_shapes.hpp"

#include <array>
#include <cmath>

namespace rigid_body_sim::contact_reference {

namespace {

/// One point of a body against a plane, at an arm that turns with the body or stays below it.
template <class Arm>
Element pointOn(std::size_t body, const Rigid& rigid, const Ground& ground, const Law& law,
                const Arm& arm) {
  Element e;
  e.a = body;
  e.reduced_mass = rigid.mass;
  e.law = law;
  e.look = [body, ground, arm](const std::vector<Pose>& at) {
    const Pose& p = at[body];
    Look look;
    look.n = ground.n;
    look.arm_a[0] = arm(p.R(), ground.n);
    look.arm_b[0].setZero();
    look.depth[0] = ground.n.dot(ground.origin - p.x - look.arm_a[0]);
    look.rate[0] = -ground.n.dot(p.velocityAt(look.arm_a[0]));
    return look;
  };
  return e;
}

}  // namespace

Element corner(std::size_t body, const Rigid& rigid, const Vec& r, const Ground& ground,
               const Law& law) {
  return pointOn(body, rigid, ground, law, [r](const Mat& R, const Vec&) { return Vec(R * r); });
}

Element ball(std::size_t body, const Rigid& rigid, const Vec& c, Real radius, const Ground& ground,
             const Law& law) {
  return pointOn(body, rigid, ground, law,
                 [c, radius](const Mat& R, const Vec& n) { return Vec(R * c - radius * n); });
}

Element ellipsoid(std::size_t body, const Rigid& rigid, const Vec& semi_axes, const Ground& ground,
                  const Law& law) {
  return pointOn(body, rigid, ground, law, [semi_axes](const Mat& R, const Vec& n) {
    const Vec m = R.transpose() * n;
    Vec x;
    Real size = 0;
    for (int i = 0; i < 3; ++i) size += semi_axes[i] * semi_axes[i] * m[i] * m[i];
    for (int i = 0; i < 3; ++i) x[i] = -semi_axes[i] * semi_axes[i] * m[i] / std::sqrt(size);
    return Vec(R * x);
  });
}

Element rim(std::size_t body, const Rigid& rigid, Real z, Real radius, const Ground& ground,
            const Law& law) {
  Element e;
  e.a = body;
  e.reduced_mass = rigid.mass;
  e.rim_radius = radius;
  e.law = law;
  e.look = [=](const std::vector<Pose>& at) {
    const Pose& p = at[body];
    const Vec a = p.R().col(2), w = p.R() * p.w, c = z * a, n = ground.n;
    const Real cosine = n.dot(a), sine = a.cross(n).norm();
    const Vec down = (cosine * a - n) / sine, side = a.cross(down);
    Look look;
    look.count = 4;
    look.n = n;
    look.arm_a = {Vec(c + radius * down), Vec(c + radius * side), Vec(c - radius * side),
                  Vec(c - radius * down)};
    look.arm_b.fill(Vec::Zero());
    // sin² = 1 − cos²; the centre sinks at its own speed, and so do the two points at its height
    const Real sine_dot = -cosine * n.dot(w.cross(a)) / sine;
    const Real depth = n.dot(ground.origin - p.x - c), rate = -n.dot(p.velocityAt(c));
    const std::array<Real, 4> share{1, 0, 0, -1};
    for (std::size_t j = 0; j < 4; ++j) {
      look.depth[j] = depth + share[j] * radius * sine;
      look.rate[j] = rate + share[j] * radius * sine_dot;
    }
    return look;
  };
  return e;
}

Element balls(std::size_t a, const Rigid& of_a, Real radius_a, std::size_t b, const Rigid& of_b,
              Real radius_b, const Law& law) {
  Element e;
  e.a = a;
  e.b = b;
  e.reduced_mass = of_a.mass * of_b.mass / (of_a.mass + of_b.mass);
  e.law = law;
  e.look = [=](const std::vector<Pose>& at) {
    const Vec apart = at[a].x - at[b].x, u = at[a].v - at[b].v;
    const Real distance = apart.norm();
    Look look;
    look.n = apart / distance;
    look.depth[0] = radius_a + radius_b - distance;
    look.rate[0] = -look.n.dot(u);
    look.arm_a[0] = -(radius_a - look.depth[0] / 2) * look.n;
    look.arm_b[0] = (radius_b - look.depth[0] / 2) * look.n;
    const Vec n_dot = (u - look.n * look.n.dot(u)) / distance;
    const Vec w = at[a].R() * at[a].w + at[b].R() * at[b].w;
    look.turn = look.n.cross(n_dot) + look.n * (look.n.dot(w) / 2);
    return look;
  };
  return e;
}

}  // namespace rigid_body_sim::contact_reference
