// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parts of space, relative to the domain's origin: where particles are placed, where they come in and go out.
#include "core/particles/domain.hpp"

#include <variant>

namespace physics {

struct BoxRegion {
    core::Vec3 low = core::Vec3::Zero(), high = core::Vec3::Zero(); ///< [m]
};

/// A cylinder between two points on its axis.
struct CylinderRegion {
    core::Vec3 from = core::Vec3::Zero(), to = core::Vec3::Zero(); ///< [m]
    double radius = 0.0;                                           ///< [m]
};

struct SphereRegion {
    core::Vec3 centre = core::Vec3::Zero(); ///< [m]
    double radius = 0.0;                    ///< [m]
};

using Region = std::variant<BoxRegion, CylinderRegion, SphereRegion>;

[[nodiscard]] bool contains(const Region& region, const core::Vec3& x);

/// The point of the region that is nearest to x [m].
[[nodiscard]] core::Vec3 nearest_point(const Region& region, const core::Vec3& x);

/// Evenly distributed in the region when the three numbers are in (0, 1) [m].
[[nodiscard]] core::Vec3 point_in(const Region& region, const core::Vec3& uniform);

/// All points up to `distance` beyond the faces and ends of the region; edges stay sharp.
[[nodiscard]] Region grown(const Region& region, double distance);

/// Volume [m3].
[[nodiscard]] double volume_of(const Region& region);

} // namespace physics
