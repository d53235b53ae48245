// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Conductivities that jump between neighbouring cells of a cube, where no coarse cell would cut it.
#include "tests/support/conduction_boxes.hpp"
#include <cmath>
#include <cstdint>

namespace test {

/// A number in [0, 1) that looks random, for cell (i, j, k).
[[nodiscard]] inline double scattered(int i, int j, int k)
{
    std::uint64_t x = std::uint64_t(i) + 1000003ULL * std::uint64_t(j) + 998244353ULL * std::uint64_t(k) + 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return double((x ^ (x >> 31)) >> 11) / 9007199254740992.0;
}

struct JumpCase {
    const char* name;
    double (*value)(int i, int j, int k, double low);
};

/// 1 in some cells, `low` in others.
inline constexpr std::array jump_cases{
    JumpCase{"half of the cells", [](int i, int j, int k, double low) { return scattered(i, j, k) < 0.5 ? 1.0 : low; }},
    JumpCase{"a fifth of the cells", [](int i, int j, int k, double low) { return scattered(i, j, k) < 0.2 ? 1.0 : low; }},
    JumpCase{"four fifths of the cells", [](int i, int j, int k, double low) { return scattered(i, j, k) < 0.8 ? 1.0 : low; }},
    JumpCase{"any value between", [](int i, int j, int k, double low) { return std::pow(low, scattered(i, j, k)); }},
    JumpCase{"cubes of 3 cells", [](int i, int j, int k, double low) { return (i / 3 + j / 3 + k / 3) % 2 == 0 ? 1.0 : low; }},
    JumpCase{"every third layer", [](int, int j, int, double low) { return j % 3 == 0 ? 1.0 : low; }},
    JumpCase{"three of six layers", [](int, int j, int, double low) { return j / 3 % 2 == 0 ? 1.0 : low; }},
    JumpCase{"slanted layers", [](int i, int j, int k, double low) { return (i + j + k) / 3 % 2 == 0 ? 1.0 : low; }},
    JumpCase{"a bed", [](int, int j, int, double low) { return j < 13 ? low : 1.0; }},
};

[[nodiscard]] inline ConductionProblem jump_problem(const JumpCase& c, int n, std::array<int, 3> blocks, double low)
{
    const auto edge = uniform(n, double(n));
    return box_problem({{edge, edge, edge}, blocks}, [&](double x, double y, double z) { return c.value(int(x), int(y), int(z), low); });
}

} // namespace test
