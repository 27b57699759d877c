#include "support/reference_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace rigid_body_sim::contact_reference {

std::vector<Pose> Scene::run(const std::vector<Pose>& start, Real duration) {
  return track(start, duration, 1).back();
}

std::vector<std::vector<Pose>> Scene::track(const std::vector<Pose>& start, Real duration,
                                            int intervals) {
  begin(start);
  std::vector<std::vector<Pose>> poses_then{start};
  for (int k = 0; k < intervals; ++k) {
    goOn(duration / static_cast<Real>(intervals));
    poses_then.push_back(poses(y_));
  }
  return poses_then;
}

void Scene::begin(const std::vector<Pose>& start) {
  y_.assign(kBody * bodies.size() + kOwn * elements.size(), 0);
  modes_.assign(elements.size(), Mode());
  for (std::size_t i = 0; i < bodies.size(); ++i) setPose(i, start[i]);
  switchModes();
}

void Scene::goOn(Real duration) {
  for (Real t = 0; t < duration;) {
    const Real left = duration - t, h = std::min(left, longestStep());
    const Real done = advance(h);
    t = done == left ? duration : t + done;
  }
}

void Scene::setPose(std::size_t i, const Pose& p) {
  Real* y = y_.data() + kBody * i;
  for (int k = 0; k < 3; ++k) {
    y[k] = p.x[k];
    y[3 + k] = p.v[k];
    y[10 + k] = p.w[k];
  }
  for (int k = 0; k < 4; ++k) y[6 + k] = p.q.coeffs()[k];
}

std::vector<Pose> Scene::poses(const Numbers& y) const {
  std::vector<Pose> result;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Real* at = y.data() + kBody * i;
    Pose p{{at[0], at[1], at[2]}, {at[3], at[4], at[5]}, Quat(), {at[10], at[11], at[12]}};
    p.q = Quat(at[9], at[6], at[7], at[8]).normalized();
    result.push_back(p);
  }
  return result;
}

const Real* Scene::ownOf(const Numbers& y, std::size_t k) const {
  return y.data() + kBody * bodies.size() + kOwn * k;
}

Scene::Numbers Scene::rates(const Numbers& y) const {
  const std::vector<Pose> at = poses(y);
  std::vector<Load> loads;
  for (const Rigid& body : bodies) loads.push_back({body.mass * g});
  Numbers dy(y.size(), 0);
  for (std::size_t k = 0; k < elements.size(); ++k)
    if (modes_[k].touching())
      addElement(k, at, ownOf(y, k), loads, dy.data() + (ownOf(y, k) - y.data()));
  for (std::size_t i = 0; i < bodies.size(); ++i)
    setRates(bodies[i], at[i], loads[i], dy.data() + kBody * i);
  return dy;
}

void Scene::addElement(std::size_t k, const std::vector<Pose>& at, const Real* own,
                       std::vector<Load>& loads, Real* own_dot) const {
  const Element& e = elements[k];
  const Action act(e, modes_[k], at);
  Vec pull = Vec::Zero();
  if (e.law.mu > 0) {
    const Slider slider = slide(e, modes_[k], act, own);
    pull = slider.pull;
    const Vec s_dot = slider.rate + act.look.turn.cross(Vec(own[0], own[1], own[2]));
    for (int i = 0; i < 3; ++i) own_dot[i] = s_dot[i];
  }
  const auto push = [&](Load& load, Real sign, const std::array<Vec, 4>& arms, const Vec& center) {
    load.force += sign * (act.total * act.look.n + pull);
    for (std::size_t j = 0; j < act.look.count; ++j)
      load.torque += sign * act.normal[j] * arms[j].cross(act.look.n);
    load.torque += sign * center.cross(pull);
  };
  push(loads[e.a], 1, act.look.arm_a, act.center_a);
  if (e.b != Element::kNone) push(loads[e.b], -1, act.look.arm_b, act.center_b);
  if (e.rim_radius == 0 || e.law.mu == 0) return;
  const Slider turning = spin(e, modes_[k], act, own);
  loads[e.a].torque += turning.pull[0] * act.look.n;
  own_dot[3] = turning.rate[0];
}

void Scene::setRates(const Rigid& body, const Pose& p, const Load& load, Real* d) {
  const Vec spun = body.moments.cwiseProduct(p.w);
  const Vec w_dot = (p.R().transpose() * load.torque - p.w.cross(spun)).cwiseQuotient(body.moments);
  const Quat q_dot = p.q * Quat(0, p.w[0], p.w[1], p.w[2]);
  for (int k = 0; k < 3; ++k) {
    d[k] = p.v[k];
    d[3 + k] = load.force[k] / body.mass;
    d[10 + k] = w_dot[k];
  }
  for (int k = 0; k < 4; ++k) d[6 + k] = q_dot.coeffs()[k] / 2;
}

Scene::Numbers Scene::stepped(Real h) const {
  const auto ahead = [this](Real by, const Numbers& rate) {
    Numbers y = y_;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += by * rate[i];
    return y;
  };
  const Numbers a = rates(y_), b = rates(ahead(h / 2, a)), c = rates(ahead(h / 2, b)),
                d = rates(ahead(h, c));
  Numbers y = y_;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  return y;
}

bool Scene::isBelow(const Numbers& y) const {
  const std::vector<Pose> at = poses(y);
  for (std::size_t k = 0; k < elements.size(); ++k)
    for (Real guard : guardsOf(elements[k], modes_[k], ownOf(y, k), at))
      if (guard < 0) return true;
  return false;
}

void Scene::switchModes() {
  const std::vector<Pose> at = poses(y_);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    Real* own = y_.data() + kBody * bodies.size() + kOwn * k;
    for (int tries = 0;; ++tries) {
      if (tries == 100) throw std::runtime_error("the modes of the reference switch for ever");
      const Guards all = guardsOf(elements[k], modes_[k], own, at);
      const auto below = std::find_if(all.begin(), all.end(), [](Real x) { return x < 0; });
      if (below == all.end()) break;
      if (flip(modes_[k], static_cast<std::size_t>(below - all.begin())))
        std::fill_n(own, kOwn, Real(0));
    }
  }
}

Real Scene::longestStep() const {
  Real longest = flight_step;
  const std::vector<Pose> at = poses(y_);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (!modes_[k].touching()) continue;
    longest = std::min(longest, contact_step);
    if (elements[k].law.p == 1) continue;
    const Look look = elements[k].look(at);
    for (std::size_t j = 0; j < look.count; ++j)
      if (modes_[k].touches[j] && look.rate[j] != 0)
        longest = std::min(longest, std::max(1e-9L, 0.1L * look.depth[j] / std::abs(look.rate[j])));
  }
  return longest;
}

Real Scene::advance(Real h) {
  Numbers end = stepped(h);
  if (!isBelow(end)) {
    y_ = end;
    return h;
  }
  Real before = 0, after = h;
  for (int halving = 0; halving < 60 && after - before > 1e-19L; ++halving) {
    const Real middle = (before + after) / 2;
    Numbers there = stepped(middle);
    if (isBelow(there)) {
      after = middle;
      end = there;
    } else {
      before = middle;
    }
  }
  y_ = end;
  switchModes();
  return after;
}

}  // namespace rigid_body_sim::contact_reference
