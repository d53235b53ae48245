// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A box whose sides and inner grid surfaces are sine waves; opposite sides stay congruent, so that any of them may repeat.
#include "core/grid/box.hpp"

namespace core {

struct Waves {
    double amplitude = 0; ///< [m]
    int count = 1;        ///< along each edge
};

/// Moves x by a sine of y, y by one of z, and z by one of x.
/// @throws ConfigError as make_box(), or if the waves are so steep that cells fold.
[[nodiscard]] MultiBlock make_wavy_box(const Box& box, const Waves& waves);

} // namespace core
