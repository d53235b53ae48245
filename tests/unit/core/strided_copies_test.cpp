// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/strided_copies.hpp"
#include <doctest/doctest.h>
#include <numeric>
#include <random>

TEST_CASE("rectangles of copies move every element to its place, however regular or not")
{
    std::mt19937 random(7);
    std::vector<double> from(4000);
    std::iota(from.begin(), from.end(), 1.0);
    for (int round = 0; round < 200; ++round) {
        core::StridedCopies copies;
        std::vector<double> to(4000, 0.0), expected(4000, 0.0);
        const auto pick = [&](int n) { return std::ptrdiff_t(random() % unsigned(n)); };
        const std::ptrdiff_t rows = 1 + pick(5), columns = 1 + pick(5), to_pitch = 20 + pick(9), from_pitch = 20 + pick(9),
                             step = 1 + pick(3);
        for (std::ptrdiff_t r = 0; r < rows; ++r)
            for (std::ptrdiff_t c = 0; c < columns; ++c) {
                const std::ptrdiff_t astray = pick(10) == 0 ? 2000 + pick(1900) : 0; // some break the rows
                const std::ptrdiff_t t = r * to_pitch + c + astray, f = r * from_pitch + c * step;
                copies.add(t, f);
                expected[std::size_t(t)] = from[std::size_t(f)];
            }
        copies.copy(from.data(), to.data());
        CHECK(to == expected);
    }
}
