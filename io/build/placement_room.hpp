// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How much room the particles of a species have at the start, and how many fill a part of it.
#include "io/scene/scene.hpp"

namespace io {

/// A corner of the domain moved by a share of the largest diameter along the axes that have walls [m].
[[nodiscard]] core::Vec3 moved_corner(const Scene& scene, const Species& species, core::Vec3 corner, double share);

/// Corners of the box of the centres [m]: those given, or as near to the walls as the largest sphere can be.
[[nodiscard]] core::Vec3 low_of(const Scene& scene, const Species& species);
[[nodiscard]] core::Vec3 high_of(const Scene& scene, const Species& species);

/// Volume of all that the largest spheres with centres in the region of the species reach, within the domain [m3]; of a round region that
/// walls cut to about a thousandth.
[[nodiscard]] double room_of(const Scene& scene, const Species& species);

/// The number that fills `species.volume_fraction` of its room.
[[nodiscard]] int filling_count(const Scene& scene, const Species& species);

} // namespace io
