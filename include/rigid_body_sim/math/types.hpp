#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Aliases of the mathematics that every layer shares. Kernels are templates on the scalar T.
namespace rigid_body_sim {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
template <class T>
using Quaternion = Eigen::Quaternion<T>;

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

}  // namespace rigid_body_sim
