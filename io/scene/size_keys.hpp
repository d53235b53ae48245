// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The sizes of the particles of a species, as the user describes them.
#include "physics/particles/size_distribution.hpp"
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace io {

class Schema;

// In the order of physics::ShareOf.
inline constexpr std::array<std::string_view, 2> share_of_words{"number", "mass"};

struct LognormalKeys {
    double median = 0.0, deviation = 0.0, smallest = 0.0, largest = 0.0; ///< diameters [m]; the deviation is geometric [-]
    bool operator==(const LognormalKeys&) const = default;
};

/// One of the three is there.
struct SizeKeys {
    physics::ShareOf share_of = physics::ShareOf::mass;
    std::vector<std::array<double, 2>> list;  ///< diameter [m], share
    std::vector<std::array<double, 2>> sieve; ///< diameter [m], share that passes
    std::optional<LognormalKeys> lognormal;
    bool operator==(const SizeKeys&) const = default;

    /// @throws core::ConfigError as physics/particles/size_distribution.hpp says.
    [[nodiscard]] physics::SizeDistribution distribution() const;
};

void describe(Schema& s, LognormalKeys& p);
void describe(Schema& s, SizeKeys& p);

} // namespace io
