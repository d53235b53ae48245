// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Flow in a square cavity under a lid that moves, at Re = 100, against a solution of stream function and vorticity on 256 x 256
// points that agrees with Botella & Peyret (1998) within 1e-5 (NUMERICS C1.4).
#include "tests/support/cavity.hpp"
#include <doctest/doctest.h>

namespace {

constexpr std::array<test::CavityReference, 8> below_lid{{{0.0547, -0.03723},
                                                          {0.1719, -0.10174},
                                                          {0.2813, -0.15767},
                                                          {0.4531, -0.21397},
                                                          {0.6172, -0.13880},
                                                          {0.7344, 0.00418},
                                                          {0.8516, 0.23654},
                                                          {0.9531, 0.69101}}};
constexpr std::array<test::CavityReference, 7> from_side{
    {{0.0625, 0.09480}, {0.1563, 0.16482}, {0.2344, 0.17955}, {0.5, 0.05754}, {0.8047, -0.25353}, {0.9063, -0.17707}, {0.9531, -0.09339}}};

/// Over the speed of the lid.
double cavity_error(int cells)
{
    const test::CavityRun run({.cells = cells, .reynolds = 100, .until = 20}); // changes by less than 1e-5 after that
    return run.error(below_lid, from_side);
}

} // namespace

TEST_CASE("the flow in a cavity under a moving lid, to second order")
{
    const double coarse = cavity_error(24), fine = cavity_error(48);
    MESSAGE("error over the lid's speed, 24 and 48 cells: ", coarse, ", ", fine);
    CHECK(fine < 2e-3);
    CHECK(std::log2(coarse / fine) > 1.7); // the lid's corners, where the velocity jumps, cost a little
}
