#include "support/random_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace rigid_body_sim {

double Draw::uniform(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator_);
}

Vector3d Draw::vector(double size) {
  Vector3d v;
  do v = Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  while (v.norm() > 1 || v.norm() < 0.1);
  return size * v.normalized();
}

Quaterniond Draw::attitude() {
  Eigen::Vector4d c;
  do c = Eigen::Vector4d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  while (c.norm() > 1 || c.norm() < 0.1);
  return Quaterniond(c.normalized());
}

Body Draw::box(double decades) {
  Vector3d square;  // of the edges
  for (int i = 0; i < 3; ++i) square[i] = std::pow(10, 2 * uniform(-decades, 0));
  std::sort(square.data(), square.data() + 3, [](double a, double b) { return a > b; });
  Body body;
  body.name = "box";
  body.mass = uniform(0.5, 5);
  body.I = body.mass / 12 *
           Vector3d(square[1] + square[2], square[0] + square[2], square[0] + square[1]);
  body.inv_I = body.I.cwiseInverse();
  body.X_BP.setIdentity();
  body.q_BP.setIdentity();
  body.split = rotationSplit(body.inv_I);
  return body;
}

BodyState Draw::state(const Body& body, double w) {
  BodyState s;
  s.x_W = vector(uniform(0, 1));
  s.p_W = body.mass * vector(uniform(0, 1));
  s.q_WP = attitude();
  s.L_P = body.I.cwiseProduct(vector(w));
  s.L_W = rotate(s.q_WP, s.L_P);
  return s;
}

}  // namespace rigid_body_sim
