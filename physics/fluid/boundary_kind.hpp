// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a boundary of the domain may do to the fluid.

namespace physics {

enum class BoundaryKind : unsigned char {
    wall,     ///< the fluid has the velocity of the wall
    slip,     ///< it has that velocity across the wall and no friction along it
    symmetry, ///< the same, and the pressure has no gradient across it: a plane that halves a symmetric flow
    inflow,   ///< the velocity is given
    outflow,  ///< the pressure is given; what flows back comes from fluid at rest, so that it cannot feed on itself
    pressure  ///< the pressure is given; what flows in has the velocity of the cells inside
};

[[nodiscard]] inline bool slips(BoundaryKind kind) { return kind == BoundaryKind::slip || kind == BoundaryKind::symmetry; }
[[nodiscard]] inline bool gives_pressure(BoundaryKind kind) { return kind == BoundaryKind::outflow || kind == BoundaryKind::pressure; }

} // namespace physics
