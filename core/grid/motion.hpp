// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How positions and vectors change from one block to the next: not at all inside the domain, by a shift or a turn through a period.
#include "core/base/vec3.hpp"

namespace core {

/// A turn, then a shift.
struct Motion {
    Vec3 shift = Vec3::Zero(); ///< [m]
    Mat3 turn = Mat3::Identity();
    bool turns = false; ///< else `turn` is the identity and takes no part, so that shifts alone keep their bits

    Motion() = default;
    explicit Motion(const Vec3& shift) : shift(shift) {}

    [[nodiscard]] bool is_identity() const { return !turns && shift.isZero(0); }
    [[nodiscard]] Vec3 of_position(const Vec3& x) const { return turns ? Vec3(turn * x + shift) : Vec3(x + shift); }
    [[nodiscard]] Vec3 of_vector(const Vec3& v) const { return turns ? Vec3(turn * v) : v; }
    /// The position that is carried to x.
    [[nodiscard]] Vec3 origin_of(const Vec3& x) const { return turns ? Vec3(turn.transpose() * (x - shift)) : Vec3(x - shift); }
    [[nodiscard]] Motion inverse() const;
    /// This motion and then another.
    [[nodiscard]] Motion then(const Motion& next) const;
    /// Do both carry positions to the same places, to round-off?
    [[nodiscard]] bool is_same(const Motion& other) const;
};

/// A turn about an axis.
struct PeriodicTurn {
    Vec3 axis = Vec3::UnitX(); ///< of unit length
    Vec3 point = Vec3::Zero(); ///< on the axis [m]
    double angle = 0;          ///< [rad]

    [[nodiscard]] Motion motion() const;
};

} // namespace core
