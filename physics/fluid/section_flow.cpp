// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/section_flow.hpp"
#include "core/base/error.hpp"
#include "core/grid/side_tiling.hpp"
#include "physics/fluid/side_faces.hpp"
#include <algorithm>

namespace physics {
namespace {

/// Length of the domain along a direction: of the period that has the largest share in it [m].
double length_along(const core::Mesh& mesh, const core::Vec3& direction)
{
    double length = 0;
    for (const core::Vec3& period : mesh.periods()) length = std::max(length, std::abs(period.dot(direction)));
    return length;
}

/// Position beyond a face of a side = position at it + this.
core::Vec3 shift_beyond(const core::Topology& topology, core::BlockId block, core::Side side, std::size_t face)
{
    if (const auto& neighbour = topology.neighbour(block, side))
        return neighbour->motion.turns ? core::Vec3(core::Vec3::Zero()) : neighbour->motion.shift;
    if (topology.joints.joins(block, side)) return topology.joints.places[std::size_t(block)][std::size_t(side)][face].motion.shift;
    return core::Vec3::Zero();
}

} // namespace

SectionFlow::SectionFlow(const core::Mesh& mesh, const core::Vec3& direction) : direction_(direction), exits_(std::size_t(mesh.own_count()))
{
    const double length = length_along(mesh, direction);
    core::require<core::ConfigError>(length > 0, "a flow can be prescribed only along a direction in which the domain repeats");
    mean_area_ = mesh.total_volume() / length;
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        for (const core::Side side : core::all_sides) {
            const int axis = core::axis_of(side);
            const core::Extents cells = mesh.geometry(b).cells;
            const auto t = core::tangential_axes(side);
            for_each_side_face(cells, side, [&](int i, int j, int k) {
                const core::Index3 face{i, j, k};
                const auto n = std::size_t(face[t[0]] + cells[t[0]] * face[t[1]]);
                const double along = shift_beyond(mesh.topology(), mesh.global(b), side, n).dot(direction);
                if (along < -0.5 * length) exits_[std::size_t(b)].push_back({axis, face, core::is_high(side) ? 1.0 : -1.0});
            });
        }
}

double SectionFlow::through(core::LocalBlock b, core::FaceView<const double> flux) const
{
    double sum = 0;
    for (const Exit& exit : exits_[std::size_t(b)]) sum += exit.sign * flux.along(exit.axis)[exit.face];
    return sum;
}

} // namespace physics
