// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How much flows through the domain along a direction in which it repeats: fluxes through the faces where one period ends.
#include "core/grid/mesh.hpp"

namespace physics {

class SectionFlow {
public:
    /// @param direction  Of unit length.
    /// @throws core::ConfigError if the domain does not repeat along it.
    SectionFlow(const core::Mesh& mesh, const core::Vec3& direction);

    /// The part of the faces of one block [m3/s]; of a flux free of divergence the sum over all blocks is that through any section.
    [[nodiscard]] double through(core::LocalBlock b, core::FaceView<const double> flux) const;
    /// Unit vector.
    [[nodiscard]] const core::Vec3& direction() const { return direction_; }
    /// Volume of the domain over its length: the mean area of sections [m2].
    [[nodiscard]] double mean_area() const { return mean_area_; }

private:
    /// A face through which the domain is left along the direction.
    struct Exit {
        int axis;
        core::Index3 face;
        double sign; ///< of a flux that leaves
    };
    core::Vec3 direction_;
    double mean_area_ = 0;
    std::vector<std::vector<Exit>> exits_; ///< of each block of this rank
};

} // namespace physics
