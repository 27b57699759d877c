#include "dynamics/rotation/theta_rotation.hpp"

#include "dynamics/rotation/theta_motion.hpp"

namespace rigid_body_sim {
namespace {

using W = Wide<double>;

/// The greatest nome at which what the series leave out is below rounding: q³⁶ of β is 5e-18.
constexpr double kMaxNome = 0.33;

/// Whether numbers keep their digits in double: the third part of a rate is 2⁻⁵² of it, and times
/// go up to 1e15 rad over the rate of ψ.
bool isPlain(const AsymmetricPath<double>& path, W rate) {
  constexpr W kLeastAmplitude = 1e-100L;
  const W magnitude = std::abs(rate);
  return path.B > kLeastAmplitude && path.M > kLeastAmplitude && path.lambda > W(1e-290L) &&
         path.lambda < W(1e280L) && magnitude > W(1e-270L) && magnitude < W(1e280L);
}

W nomeOf(W K, W k2) {
  return std::exp(-kPi<W> * completeIntegrals(k2, W(0)).K / K);  // π K'/K
}

/// Carlson's ∫₀^∞ dt/2 / √((t+x)(t+y)(t+z)), at most one of x, y, z zero: duplication, then the
/// series of DLMF 19.36.1.
W carlsonRF(W x, W y, W z) {
  constexpr W kSeriesRange = 7e-4L;  // its sixth power, over 100, is below rounding
  for (;;) {
    const W mean = (x + y + z) / 3;
    const W X = 1 - x / mean, Y = 1 - y / mean, Z = -(X + Y);
    if (!(std::max({std::abs(X), std::abs(Y), std::abs(Z)}) > kSeriesRange)) {
      const W e2 = X * Y - Z * Z, e3 = X * Y * Z;
      return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
    }
    const W rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    const W shift = rx * (ry + rz) + ry * rz;
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
  }
}

/// u of sn and cn, within ±2K.
W argumentOf(W sn, W cn, W k2, W K) {
  const W u = std::abs(sn) * carlsonRF(cn * cn, 1 - k2 * sn * sn, 1);
  return std::copysign(cn < 0 ? 2 * K - u : u, sn);
}

/// The first 26 bits.
double high(W x) {
  const double rounded = double(x), scaled = 134217729.0 * rounded;
  return scaled - (scaled - rounded);
}

}  // namespace

std::optional<ThetaRotation> ThetaRotation::of(const AsymmetricPath<double>& path,
                                               const FreeInvariants<double>& invariants,
                                               const Quaterniond& q_WP) {
  const W K = path.half_period / 2;
  const W rate = path.rate + path.lambda * path.angle_per_half_period / path.half_period;  // of ψ
  if (!isPlain(path, rate)) return std::nullopt;
  const W nome = nomeOf(K, path.k2);
  if (!(nome <= W(kMaxNome))) return std::nullopt;
  ThetaRotation rotation;
  rotation.a_ = path.a;
  const W sign(path.turned ? -1 : 1);
  constexpr W kTurn = 2 * kPi<W>;
  rotation.setRate(kArgumentRate, path.lambda / (4 * K));   // z = π u/2K
  rotation.setRate(kPhaseRate, sign * (rate / 2) / kTurn);  // φ = ψ/2
  rotation.numbers_[kArgumentStart] = double(argumentOf(path.sn, path.cn, path.k2, K) / (4 * K));
  rotation.numbers_[kNome] = double(nome);
  rotation.setSeries(path, nome, K);
  rotation.setAmplitudes(path, nome, invariants.magnitude);
  rotation.setBefore(q_WP);
  return rotation;
}

/// In three parts, of which the first two have 26 bits.
void ThetaRotation::setRate(std::size_t first, W rate) {
  numbers_[first] = high(rate);
  rate -= numbers_[first];
  numbers_[first + 1] = high(rate);
  numbers_[first + 2] = double(rate - numbers_[first + 1]);
}

/// ϑ₄ and ϑ₁ of (z + iη | q²), with E = e^(−2η) ≥ q: every power below is at most 1, and the ratio
/// of β to α at z = 0 is B/(1 + A).
void ThetaRotation::setSeries(const AsymmetricPath<double>& path, W nome, W K) {
  const W A2 = path.A * path.A, B2 = path.B * path.B;
  const W eta = kPi<W> / (2 * K) * path.B * carlsonRF(path.k2 * A2, path.k2, B2 + path.k2 * A2);
  const W D = -std::expm1(-2 * eta), E = 1 - D;  // η may be small
  const W turned(path.turned ? -1 : 1), first(path.first ? 1 : -1);
  const W q2 = nome * nome, q4 = q2 * q2;
  W alpha_0(1), beta_0(0), cosines[4], sines[4];
  W power(1), step(-q2), E_power(1);  // of n: ±q^(2n²), the next over it, Eⁿ
  for (std::size_t n = 0; n < 4; ++n) {
    power *= step;
    step *= q4;
    E_power *= E;
    const W growing = power / E_power, shrinking = power * E_power;
    numbers_[kEvenReal + n] = double(growing + shrinking);
    numbers_[kEvenImaginary + n] = double(-turned * first * (growing - shrinking));
    alpha_0 += growing + shrinking;
  }
  power = E_power = W(1);  // ±q^(2n(n+1))
  step = -q4;
  W sum(1);  // 1 + E + … + E^(2n)
  for (std::size_t n = 0; n < 4; ++n) {
    const W odd_power = E_power * E_power * E;
    cosines[n] = power / E_power * sum;
    sines[n] = power / E_power * (1 + odd_power);
    beta_0 += cosines[n];
    sum += odd_power * (1 + E);
    E_power *= E;
    power *= step;
    step *= q4;
  }
  const W scale = path.B / (1 + path.A) * alpha_0 / beta_0;
  for (std::size_t n = 0; n < 4; ++n) {
    numbers_[kOddCosines + n] = double(first * scale * cosines[n]);
    numbers_[kOddSines + n] = double(-turned * first * scale * sines[n] / D);
  }
}

/// Of sn, cn and dn by quotients of theta functions at z and at 0.
void ThetaRotation::setAmplitudes(const AsymmetricPath<double>& path, W nome, double magnitude) {
  W theta_2(1), theta_3(1), theta_4(1);
  W power(1), n_power(1), sign(1);  // q^(n²), qⁿ
  for (int n = 1; n <= 5; ++n) {
    power *= n_power * n_power * nome;
    n_power *= nome;
    sign = -sign;
    theta_2 += power * n_power;
    theta_3 += 2 * power;
    theta_4 += 2 * sign * power;
  }
  const W turned(path.turned ? -1 : 1), size(magnitude);
  numbers_[kAmplitudes] = double(turned * size * path.A * theta_4 / theta_3);
  numbers_[kAmplitudes + 1] = double(size * path.M * theta_3 / theta_2);
  numbers_[kAmplitudes + 2] = double(turned * size * path.B * theta_4 / theta_2);
}

/// So that the motion starts at q_WP, and with the scale that makes its product a unit.
void ThetaRotation::setBefore(const Quaterniond& q_WP) {
  const auto at = [this](int i) { return numbers_[static_cast<std::size_t>(i)]; };
  Quad<double> turn;
  Triple<double> L_P;
  if (a_ == 0)
    thetaFactor<true>(at, 0.0, turn, L_P);
  else
    thetaFactor<false>(at, 0.0, turn, L_P);
  const Quaterniond before = product(q_WP, Quaterniond(turn.w, turn.x, turn.y, turn.z).conjugate());
  for (std::size_t i = 0; i < 4; ++i)
    numbers_[kBefore + i] = before.coeffs()(static_cast<Eigen::Index>(i)) / squaredNorm(turn);
}

RotationState<double> ThetaRotation::at(double dt) const {
  const auto number = [this](int i) { return numbers_[static_cast<std::size_t>(i)]; };
  Quad<double> q_WP;
  Triple<double> L_P;
  if (a_ == 0)
    thetaMotion<true>(number, dt, q_WP, L_P);
  else
    thetaMotion<false>(number, dt, q_WP, L_P);
  return {Quaterniond(q_WP.w, q_WP.x, q_WP.y, q_WP.z), Vector3d(L_P.x, L_P.y, L_P.z)};
}

}  // namespace rigid_body_sim
