#include "support/reference_laws.hpp"

#include <cmath>

namespace rigid_body_sim::reference {

Law spring(const Spring::End& from, const Spring::End& to, const Spring::Constants& constants) {
  return [=](const std::vector<Body>&, const Motions& m, Loads& loads) {
    struct Point {
      Vector arm = Vector::Zero(), r, v = Vector::Zero();
    };
    const auto pointOf = [&m](const Spring::End& end) {
      Point p;
      p.r = end.point.cast<Real>();
      if (end.body == kWorld) return p;
      const Motion& body = m[end.body];
      const Matrix R = body.R();
      p.arm = R * p.r;
      p.r = body.x + p.arm;
      p.v = body.v + (R * body.w).cross(p.arm);
      return p;
    };
    const Point a = pointOf(from), b = pointOf(to);
    const Vector d = b.r - a.r;
    const Real l = d.norm();
    const Real l_dot = d.dot(b.v - a.v) / l;
    const Real tension = Real(constants.stiffness) * (l - Real(constants.rest_length)) +
                         Real(constants.damping) * l_dot;
    const Vector f = tension / l * d;
    if (from.body != kWorld) {
      loads[from.body].f_W += f;
      loads[from.body].tau_W += a.arm.cross(f);
    }
    if (to.body != kWorld) {
      loads[to.body].f_W -= f;
      loads[to.body].tau_W -= b.arm.cross(f);
    }
  };
}

Law centralGravity(std::size_t body, const Vector3d& center, double mu, bool gradient) {
  return [=](const std::vector<Body>& bodies, const Motions& m, Loads& loads) {
    const Vector r = m[body].x - center.cast<Real>();
    const Real r3 = r.norm() * r.squaredNorm();
    loads[body].f_W -= Real(mu) * Real(bodies[body].mass) / r3 * r;
    if (!gradient) return;
    const Matrix R = m[body].R();
    const Vector I_r = R * (bodies[body].I.cast<Real>().asDiagonal() * (R.transpose() * r));
    loads[body].tau_W += 3 * Real(mu) / (r3 * r.squaredNorm()) * r.cross(I_r);
  };
}

Law drag(std::size_t body, const Drag::Coefficients& drag) {
  return [=](const std::vector<Body>&, const Motions& m, Loads& loads) {
    loads[body].f_W -= (Real(drag.linear) + Real(drag.quadratic) * m[body].v.norm()) * m[body].v;
    loads[body].tau_P -= Real(drag.angular) * m[body].w;
  };
}

Law mediumDrag(std::size_t body, const MediumDrag::Coefficients& drag, const Vector3d& w_W) {
  return [=](const std::vector<Body>&, const Motions& m, Loads& loads) {
    const Matrix R = m[body].R(), R_PD = drag.R_PD.cast<Real>();
    const Vector c = drag.center_P.cast<Real>(), w_P = m[body].w;
    const Vector u = R.transpose() * (m[body].v - w_W.cast<Real>()) + w_P.cross(c);
    const auto along = [&R_PD](const Vector3d& factors, const Vector& v_P, bool squared) -> Vector {
      const Vector v = R_PD.transpose() * v_P;
      Vector sum = Vector::Zero();
      for (int i = 0; i < 3; ++i)
        sum += Real(factors[i]) * (squared ? std::abs(v[i]) : 1) * v[i] * R_PD.col(i);
      return sum;
    };
    const Vector f = -(Real(drag.linear.alike) + Real(drag.quadratic.alike) * u.norm()) * u -
                     along(drag.linear.axes, u, false) - along(drag.quadratic.axes, u, true);
    loads[body].f_W += R * f;
    loads[body].tau_P +=
        c.cross(f) - Real(drag.angular.alike) * w_P - along(drag.angular.axes, w_P, false);
  };
}

Law buoyancy(std::size_t body, double displaced, const Vector3d& centroid_P, const Vector3d& g_W) {
  return [=](const std::vector<Body>&, const Motions& m, Loads& loads) {
    const Vector f = -Real(displaced) * g_W.cast<Real>();
    loads[body].f_W += f;
    loads[body].tau_W += (m[body].R() * centroid_P.cast<Real>()).cross(f);
  };
}

}  // namespace rigid_body_sim::reference
