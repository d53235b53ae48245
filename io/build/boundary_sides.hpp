// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The sides of blocks that are the boundaries of a scene's grid, before there is a mesh.
#include "core/grid/topology.hpp"
#include "io/scene/scene.hpp"
#include <functional>

namespace io {

/// What a velocity carries through a boundary.
struct FlowThrough {
    double net = 0;        ///< out of the domain [m3/s]
    double magnitudes = 0; ///< sum over the faces [m3/s]
    double area = 0;       ///< [m2]
    double steepest = 0;   ///< sine of the largest angle between the velocity and a face
    std::string face;      ///< which has that angle: block, side and cell beside it
};

class BoundarySides {
public:
    /// @throws core::ConfigError if the grid cannot be made.
    explicit BoundarySides(const Grid& grid);

    /// Names of the boundaries, in the order of the alphabet.
    [[nodiscard]] std::vector<std::string> names() const;
    /// @param velocity  By place; where it is zero it has no angle [m/s].
    [[nodiscard]] FlowThrough flow_through(const std::string& name, const std::function<core::Vec3(const core::Vec3&)>& velocity) const;

private:
    core::MultiBlock blocks_;
    core::Topology topology_;
};

} // namespace io
