// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which particles may soon touch which triangles of a surface, four pairs at a time.
#include "core/base/four.hpp"
#include "physics/particles/wall_surface.hpp"

namespace physics {

/// Where the centres of four particles must lie to be near four triangles.
struct SurfaceFilter {
    std::array<core::Four, CentreBounds::size> value;

    void set(int lane, const CentreBounds& bounds)
    {
        for (std::size_t n = 0; n < CentreBounds::size; ++n) value[n][lane] = bounds.value[n];
    }
    /// Of each pair: not zero if the centre (x, y, z) is within the bounds.
    [[nodiscard]] auto operator()(const core::Four& x, const core::Four& y, const core::Four& z) const
    {
        const auto along = [&](std::size_t n) { return core::Four(value[n] * x + value[n + 1] * y + value[n + 2] * z - value[n + 3]); };
        const core::Four height = along(0), one = along(4), two = along(8), zero = 1.0 - one - two;
        return (height > value[12]) & (height < value[13]) & (one > value[14]) & (two > value[15]) & (zero > value[16]);
    }
};

} // namespace physics
