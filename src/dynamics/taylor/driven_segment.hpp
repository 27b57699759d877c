#pragma once

#include "dynamics/taylor/taylor_drive.hpp"
#include "dynamics/taylor/taylor_segment.hpp"

namespace rigid_body_sim {

/// A TaylorSegment of a body with motors: HeldWrench::drive must be there. Its degree and length do
/// not depend on what is to come, so that a command that was known beforehand and one that was not
/// give the same bits.
template <class T>
class DrivenSegmentT : private TaylorSegmentT<T> {
  using Base = TaylorSegmentT<T>;

 public:
  /// since [s]: the time of the start, from drive->start on.
  DrivenSegmentT(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                 const BodyStateT<T>& start, T since, const ErrorBound& bound = {});

  void startAnew(const HeldWrench& same_wrench, const BodyStateT<T>& start, T since);

  const BodyStateT<T>& start() const { return Base::start(); }
  T validFor() const { return Base::validFor(); }

  /// See TaylorSegment. L_W gains the integral of the torque from outside alone: the motors'
  /// reactions leave it at its last bit.
  BodyStateT<T> at(T dt) const;

 private:
  /// The series of exp(−rate t) factor, t in units of time.
  using Decay = T[kHighestTaylorDegree + 1];

  void setUpDrive(const HeldWrench& wrench, T since);
  void addDecay(const ActuatorDrive::Lag& lag, T since);
  void findAcceleration();
  T driveRate(const ActuatorDrive& drive, T since) const;
  T lengthOf(const typename TaylorDrive<T>::Coefficients& series, T size) const;

  TaylorDrive<T> drive_;
};

using DrivenSegment = DrivenSegmentT<double>;

/// The state a duration [s] >= 0 later; see advanceTaylor.
template <class T>
BodyStateT<T> advanceDriven(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                            BodyStateT<T> state, T since, T duration,
                            const ErrorBound& bound = {}) {
  constexpr int kMaxSegments = 1000000;
  T left = duration;
  DrivenSegmentT<T> segment(body, wrench, g_W, state, since, bound);
  for (int count = 0; count < kMaxSegments; ++count) {
    if (!(segment.validFor() < left)) return segment.at(left);
    state = segment.at(segment.validFor());
    left -= segment.validFor();
    since += segment.validFor();
    segment.startAnew(wrench, state, since);
  }
  throw StepTooLong(
      "the motion is too fast to be followed; a shorter time_step, slower turning or less torque "
      "is "
      "needed");
}

extern template class DrivenSegmentT<double>;
extern template class DrivenSegmentT<long double>;

}  // namespace rigid_body_sim
