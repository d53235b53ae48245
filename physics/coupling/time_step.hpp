// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far grains may move while the fluid around them is frozen.
#include "core/particles/particle_set.hpp"
#include "physics/fluid/time_step.hpp"

namespace physics {

/// Largest speed of the owned grains [m/s].
[[nodiscard]] double largest_speed(const core::ParticleSet& grains);

/// Longest step in which no grain moves by more than `share` filter widths: the filtered fields that it was told of change
/// over one width; infinite without a filter.
/// @param speed         Largest of all ranks [m/s].
/// @param acceleration  That grains may get [m/s2].
/// @source  NUMERICS B2: a quarter of the width.
[[nodiscard]] double grain_move_limit(double share, double filter_width, double speed, double acceleration);

} // namespace physics
