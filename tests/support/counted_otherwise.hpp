// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The same block with other indices.
#include "core/grid/multi_block.hpp"

namespace test {

/// Counted along k, then i from the end, then j from the end: right-handed as before.
[[nodiscard]] inline core::Vertices counted_otherwise(const core::Vertices& v)
{
    const core::Extents n = v.extents();
    core::Vertices other({n.nk, n.ni, n.nj}, 0, core::Vec3::Zero());
    core::for_each_cell(n, [&](int i, int j, int k) { other(k, n.ni - 1 - i, n.nj - 1 - j) = v(i, j, k); });
    return other;
}

} // namespace test
