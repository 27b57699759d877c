#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Aliases of the mathematics that every layer shares. Kernels are templates on the scalar T.
///
/// Eigen aligns some fixed-size types to the widest register of the instruction set, so that a
/// struct that holds one changes its layout with the compiler's flags. These do not: a user of the
/// library may compile with other flags (-mavx2, -march=native) than the library was.
namespace rigid_body_sim {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
template <class T>
using Quaternion = Eigen::Quaternion<T, Eigen::DontAlign>;

using Isometry3d = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Quaterniond = Quaternion<double>;

}  // namespace rigid_body_sim
