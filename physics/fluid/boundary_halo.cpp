// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/boundary_halo.hpp"

namespace physics {
namespace {

core::Vec3 vector_at(const core::VectorView<const double>& q, core::Index3 c) { return {q.x[c], q.y[c], q.z[c]}; }

void set(const core::VectorView<double>& q, core::Index3 c, const core::Vec3& value)
{
    q.x[c] = value.x();
    q.y[c] = value.y();
    q.z[c] = value.z();
}

/// The mirror image of a vector in the face of a side.
core::Vec3 reflected(const BlockSide& side, core::Index3 at, const core::Vec3& v)
{
    const core::Vec3& normal = side.normal[at];
    return v - 2 * normal.dot(v) * normal;
}

/// Does fluid enter through an outflow?
bool flows_back(const BlockSide& side, core::Index3 at, const core::Vec3& velocity)
{
    return side.kind == BoundaryKind::outflow && velocity.dot(side.normal[at]) < 0;
}

/// @param share  Of the given pressure that q has there.
void mirror_about_given(const BlockWalls& walls, int layers, double share, core::View<double> q)
{
    for_each_mirrored(walls, q.extents(), layers, [&](const BlockSide& side, core::Index3 inside, core::Index3 beyond) {
        q[beyond] = side.gives_pressure() ? 2 * share * side.pressure - q[inside] : q[inside];
    });
}

} // namespace

core::Vec3 mirrored(const BlockSide& side, core::Index3 at, const core::Vec3& inside)
{
    if (side.gives_pressure()) return inside;
    if (!side.slips()) return 2 * side.velocity[at] - inside;
    return side.velocity[at] + reflected(side, at, inside - side.velocity[at]);
}

core::Vec3 carried_through(const BlockSide& side, core::Index3 at, double outward, const core::Vec3& inside)
{
    if (side.kind == BoundaryKind::outflow && outward < 0) return core::Vec3::Zero();
    return 0.5 * (mirrored(side, at, inside) + inside);
}

void mirror_velocity(const BlockWalls& walls, int layers, core::VectorView<double> velocity)
{
    for_each_mirrored(walls, velocity.x.extents(), layers, [&](const BlockSide& side, core::Index3 inside, core::Index3 beyond) {
        set(velocity, beyond, mirrored(side, inside, vector_at(velocity, inside)));
    });
}

void mirror_velocity_change(const BlockWalls& walls, int component, core::View<double> change)
{
    for_each_mirrored(walls, change.extents(), 1, [&](const BlockSide& side, core::Index3 inside, core::Index3 beyond) {
        const double normal = side.normal[inside][component];
        const double factor = side.gives_pressure() ? 1 : side.slips() ? 1 - 2 * normal * normal : -1;
        change[beyond] = factor * change[inside];
    });
}

void mirror_velocity_change(const BlockWalls& walls, core::VectorView<double> change)
{
    for_each_mirrored(walls, change.x.extents(), 1, [&](const BlockSide& side, core::Index3 inside, core::Index3 beyond) {
        const core::Vec3 v = vector_at(change, inside);
        set(change, beyond, side.gives_pressure() ? v : side.slips() ? reflected(side, inside, v) : core::Vec3(-v));
    });
}

void mirror_source(const BlockWalls& walls, int layers, core::VectorView<const double> velocity, core::VectorView<double> q)
{
    for_each_mirrored(walls, q.x.extents(), layers, [&](const BlockSide& side, core::Index3 inside, core::Index3 beyond) {
        const core::Vec3 u = vector_at(velocity, inside), all = vector_at(q, inside);
        if (flows_back(side, inside, u)) return set(q, beyond, -all);
        set(q, beyond, vector_at(velocity, beyond) + (side.slips() ? reflected(side, inside, all - u) : core::Vec3(all - u)));
    });
}

void mirror_even(const BlockWalls& walls, int layers, core::View<double> q)
{
    for_each_mirrored(walls, q.extents(), layers,
                      [&](const BlockSide&, core::Index3 inside, core::Index3 beyond) { q[beyond] = q[inside]; });
}

void mirror_pressure(const BlockWalls& walls, int layers, core::View<double> pressure) { mirror_about_given(walls, layers, 1, pressure); }

void mirror_pressure_change(const BlockWalls& walls, int layers, core::View<double> change)
{
    mirror_about_given(walls, layers, 0, change);
}

} // namespace physics
