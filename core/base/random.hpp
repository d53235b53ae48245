// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random numbers that depend on a seed, a particle and a counter only: never on the order of calls, threads or ranks.
#include <Random123/philox.h>

#include <array>
#include <cstdint>

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

} // namespace core
