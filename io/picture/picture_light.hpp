// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How much light from around reaches each sphere between its neighbours.
#include "io/picture/picture.hpp"

namespace io::detail {

/// For each sphere (dx, dy, dz, mean): the covered part of the sky over a point with normal n is about mean + d . n, the
/// first two terms in spherical harmonics of the sum over neighbours within three radii.
[[nodiscard]] std::vector<std::array<float, 4>> covered_sky(const std::vector<Sphere>& spheres);

} // namespace io::detail
