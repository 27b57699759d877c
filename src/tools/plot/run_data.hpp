#pragma once

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Numbers at instants, one row an instant.
template <std::size_t N>
struct Samples {
  std::vector<double> t;  ///< [s]
  std::vector<std::array<double, N>> rows;
};

/// The same of a body.
template <std::size_t N>
struct BodySamples {
  std::string body;
  Samples<N> samples;
};

/// Samples of bodies, in the order in which the run names them first.
template <std::size_t N>
class ByBody {
 public:
  /// Those of a body; new ones where it has none yet.
  Samples<N>& of(const std::string& body) {
    const auto [known, is_new] = index_.emplace(body, all_.size());
    if (is_new) all_.push_back({body, {}});
    return all_[known->second].samples;
  }

  const std::vector<BodySamples<N>>& all() const { return all_; }
  bool empty() const { return all_.empty(); }

 private:
  std::vector<BodySamples<N>> all_;
  std::unordered_map<std::string, std::size_t> index_;
};

/// Three numbers of a row, from `begin` on.
template <std::size_t N>
Vector3d vectorAt(std::size_t begin, const std::array<double, N>& row) {
  return {row[begin], row[begin + 1], row[begin + 2]};
}

/// What there is to plot of a run. Whatever the run does not hold is empty.
struct RunData {
  std::string name;     ///< of the file or files, for titles
  double begin = 0;     ///< [s] where the zero of the instants lies in the time of the run
  ByBody<13> motion;    ///< position, quaternion, velocity, angular velocity, as in kCsvHeader
  ByBody<6> loads;      ///< force and torque of all but uniform gravity, as in kForcesHeader
  ByBody<6> applied;    ///< force [N] and torque [N m] of wrenches alone, in the axes of the body
  ByBody<3> contact;    ///< [N] force of all contacts of the body, world axes
  ByBody<3> pivot;      ///< [N] force of the pivot, in the axes of the body
  Samples<16> balance;  ///< as in kBalanceHeader
  bool has_kinetic = false;          ///< else the column of the kinetic energy is of no meaning
  std::vector<std::string> notices;  ///< what the files lack, a line each
};

/// Reads the bag, or the CSV files of one run: of its motion, forces and balance, one or more of
/// them, told apart by their first lines. Throws std::runtime_error with one line, the path first.
RunData readRun(const std::vector<std::string>& paths);

/// The same of a bag.
RunData readBagRun(const std::string& path);

}  // namespace rigid_body_sim
