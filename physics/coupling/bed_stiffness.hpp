// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How stiff a bed is as a whole: the springs of its contacts in a row.
#include "core/particles/domain.hpp"

namespace physics {

/// Layers of a bed of all grains that stands on a boundary, settled along gravity or, without it, on the nearest boundary; 1 where no
/// boundary can hold it.
/// @param solid_volume  Of all grains [m3].   @param diameter  Of the smallest grain [m].
[[nodiscard]] double bed_layers(const core::Domain& domain, const core::Vec3& gravity, double solid_volume, double diameter);

/// How stiffly a layer holds the one above it against shear, per grain [N/m]: a grain rests on three, whose normals lean by
/// sin^2 = 1/3, as in close packings; half of the lean is along the shear.
/// @param normal, tangential  Springs of one contact [N/m].
[[nodiscard]] constexpr double layer_stiffness(double normal, double tangential) { return 3.0 * (normal / 6.0 + tangential * 5.0 / 6.0); }

/// Stiffness of a bed that stands on a floor, per grain, in its slowest sway: k (pi / (2 n))^2, at most k [N/m].
/// @param layer  k, layer_stiffness() [N/m].   @param layers  n.
[[nodiscard]] double bed_stiffness(double layer, double layers);

} // namespace physics
