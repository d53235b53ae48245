// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The velocity that flows through a face, from the cell that it comes from.
#include "physics/fluid/bounded_transport.hpp"
#include "physics/fluid/index_space.hpp"

namespace physics {

/// What the value on a face follows from; `slope_x` is the gradient of the component along x [1/s].
struct UpwindCell {
    Components velocity, beyond, middle; ///< u of this cell and of that beyond the face; u + dt/2 (a - w . grad u) of this one [m/s]
    Components carrier;                  ///< w [m/s]
    Components slope_x, slope_y, slope_z;
    Components to_face, across; ///< from the centre of this cell to the face and to the centre of the cell beyond [m]
};

[[nodiscard]] inline double dot(const Components& a, const Components& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// One component on its way to the face.
struct AlongTheWay {
    double ahead, behind; ///< differences to the cell beyond the face, and to the one on the other side as the gradient has it [m/s]
    double carried;       ///< what transport and place add [m/s]
    double all;           ///< besides what all other acceleration adds [m/s]
};
[[nodiscard]] inline AlongTheWay along_the_way(const UpwindCell& cell, const Components& slope, double u, double beyond, double middle,
                                               double half_step)
{
    const double ahead = beyond - u, bend = ahead - dot(slope, cell.across);
    const double by_place = dot(slope, cell.to_face) + share_of_second_difference * bend;
    return {ahead, ahead - 2 * bend, by_place - half_step * dot(slope, cell.carrier), by_place + (middle - u)};
}

/// See limited_momentum.hpp.
/// @param half_step  dt / 2 [s].
[[nodiscard]] inline Components limited_value(const UpwindCell& cell, double half_step)
{
    constexpr double counts = 1e-2;                                // of what else accelerates, squared
    constexpr double nothing = std::numeric_limits<double>::min(); // so that 0 / 0 does not arise
    const AlongTheWay x = along_the_way(cell, cell.slope_x, cell.velocity.x, cell.beyond.x, cell.middle.x, half_step),
                      y = along_the_way(cell, cell.slope_y, cell.velocity.y, cell.beyond.y, cell.middle.y, half_step),
                      z = along_the_way(cell, cell.slope_z, cell.velocity.z, cell.beyond.z, cell.middle.z, half_step);
    const double wanted = x.carried * x.carried + y.carried * y.carried + z.carried * z.carried;
    const double ahead = x.carried * x.ahead + y.carried * y.ahead + z.carried * z.ahead;
    const double behind = x.carried * x.behind + y.carried * y.behind + z.carried * z.behind;
    // Share of the fluid of the cell that leaves it along the line: what is left bears so much more than a difference.
    const double leaving = 2 * half_step * std::abs(dot(cell.carrier, cell.across)) / dot(cell.across, cell.across);
    const double left = std::max(0.0, std::min(1.0, (1 - leaving) / (leaving + nothing)));
    const double px = x.all - x.carried, py = y.all - y.carried, pz = z.all - z.carried;
    const double pushed = counts * (px * px + py * py + pz * pz) + nothing;
    const double share = std::min(1.0, (std::max(0.0, std::min(ahead, left * behind)) + pushed) / (wanted + pushed));
    return {cell.velocity.x + share * x.all, cell.velocity.y + share * y.all, cell.velocity.z + share * z.all};
}

} // namespace physics
