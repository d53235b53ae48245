// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Levels of size, so that small spheres look for small ones among small bins and for large ones among large bins.
#include <array>
#include <vector>

namespace core {

/// Octaves of radii that are told apart, from 2^-32 m (a fifth of a nanometre) to 2^8 m.
inline constexpr int radius_octaves = 40;

/// One number for each octave.
using Octaves = std::array<double, radius_octaves>;

/// The octave of a radius [m]; what is beyond the ends belongs to them.
[[nodiscard]] int octave_of(double radius);

/// Neighbouring octaves make a level until the next one has less than half the greatest radius of the level. Spheres of nearly one size
/// are a single level.
class SizeLevels {
public:
    SizeLevels() = default;
    /// @param greatest  Greatest radius of each octave; 0 where it is empty [m].
    explicit SizeLevels(const Octaves& greatest);

    [[nodiscard]] int count() const { return int(greatest_.size()); }
    /// The level of a radius that was counted; 0 has the largest.
    [[nodiscard]] int level_of(double radius) const { return level_[std::size_t(octave_of(radius))]; }
    /// Greatest radius of a level [m].
    [[nodiscard]] double greatest(int level) const { return greatest_[std::size_t(level)]; }

private:
    std::array<int, radius_octaves> level_{};
    std::vector<double> greatest_{0.0};
};

} // namespace core
