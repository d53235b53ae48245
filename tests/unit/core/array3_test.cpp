// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/field.hpp"
#include <doctest/doctest.h>

TEST_CASE("a view addresses the interior and every halo element once")
{
    core::Array3<int> a({3, 4, 5}, 2);
    auto v = a.view();
    core::for_each({-2, -2, -2}, {5, 6, 7}, [&](int i, int j, int k) { v(i, j, k) += 1; });
    for (int x : a.data()) CHECK(x == 1);
    CHECK(&v(0, 0, 0) + v.offset(1, 2, 3) == &v(1, 2, 3));
}

TEST_CASE("a field costs nothing before it is allocated")
{
    const std::vector<core::Extents> cells{{2, 2, 2}, {3, 1, 1}};
    core::FaceField flux({"flux", "m3/s", 0, false}, cells);
    CHECK(flux.bytes() == 0);
    flux.allocate();
    CHECK(flux.bytes() == (3 * 12 + 4 + 6 + 6) * sizeof(double));
}
