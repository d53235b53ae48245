// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/size_levels.hpp"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr int lowest_exponent = -32;

} // namespace

int octave_of(double radius) { return std::clamp(std::ilogb(radius) - lowest_exponent, 0, radius_octaves - 1); }

SizeLevels::SizeLevels(const Octaves& greatest)
{
    greatest_.clear();
    for (int octave = radius_octaves - 1; octave >= 0; --octave) {
        const double radius = greatest[std::size_t(octave)];
        if (radius > 0.0 && (greatest_.empty() || radius < 0.5 * greatest_.back())) greatest_.push_back(radius);
        level_[std::size_t(octave)] = std::max(0, count() - 1);
    }
    if (greatest_.empty()) greatest_.push_back(0.0);
}

} // namespace core
