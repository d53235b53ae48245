// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random numbers that depend on a seed, a particle and a counter only: never on the order of calls, threads or ranks.
#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace core {

/// Four numbers, uniform in (0, 1), for draw number `counter` of particle `id`.
/// @source  Salmon et al. (2011), Parallel random numbers: as easy as 1, 2, 3 (Philox4x32-10).
[[nodiscard]] inline std::array<double, 4> random_uniform(std::uint64_t seed, std::int64_t id, std::uint64_t counter)
{
    const auto low = [](std::uint64_t v) { return std::uint32_t(v); };
    const auto high = [](std::uint64_t v) { return std::uint32_t(v >> 32); };
    const auto key = std::uint64_t(id);
    const auto bits = r123::Philox4x32{}({{low(key), high(key), low(counter), high(counter)}}, {{low(seed), high(seed)}});
    std::array<double, 4> u;
    for (std::size_t k = 0; k < 4; ++k) u[k] = (double(bits.v[k]) + 0.5) * 0x1p-32;
    return u;
}

/// Four numbers of normal distribution, with mean 0 and variance 1, none beyond 6.7. @source  Box, Muller (1958).
[[nodiscard]] inline std::array<double, 4> random_normal(std::uint64_t seed, std::int64_t id, std::uint64_t counter)
{
    const auto u = random_uniform(seed, id, counter);
    std::array<double, 4> normal;
    for (std::size_t pair = 0; pair < 4; pair += 2) {
        const double r = std::sqrt(-2.0 * std::log(u[pair])), angle = 2.0 * std::numbers::pi * u[pair + 1];
        normal[pair] = r * std::cos(angle);
        normal[pair + 1] = r * std::sin(angle);
    }
    return normal;
}

} // namespace core
