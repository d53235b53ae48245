// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Regions of a scene: a box between two corners, a cylinder, a sphere.
#include "physics/particles/region.hpp"
#include <optional>

namespace io {

class Schema;

struct CylinderKeys {
    core::Vec3 from = core::Vec3::Zero(), to = core::Vec3::Zero(); ///< [m]
    double radius = 0.0;                                           ///< [m]
    bool operator==(const CylinderKeys&) const = default;
};

struct SphereKeys {
    core::Vec3 centre = core::Vec3::Zero(); ///< [m]
    double radius = 0.0;                    ///< [m]
    bool operator==(const SphereKeys&) const = default;
};

/// In the coordinates of the scene. One of the three forms, or nothing.
struct RegionKeys {
    std::optional<core::Vec3> low, high; ///< Corners of a box [m]; where one is missing, that of the domain.
    std::optional<CylinderKeys> cylinder;
    std::optional<SphereKeys> sphere;
    bool operator==(const RegionKeys&) const = default;

    [[nodiscard]] bool is_round() const { return cylinder || sphere; }
    /// Is a region given as a whole?
    [[nodiscard]] bool is_whole() const { return is_round() || (low && high); }
    /// Relative to the domain's origin.
    [[nodiscard]] physics::Region region(const core::Domain& domain) const;
};

void describe(Schema& s, CylinderKeys& p);
void describe(Schema& s, SphereKeys& p);
/// Adds the keys of a region to those of a group.
void describe(Schema& s, RegionKeys& p);

} // namespace io
