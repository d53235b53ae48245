// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The 3-vectors and 3x3 tensors of the whole program.
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace core {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

} // namespace core
