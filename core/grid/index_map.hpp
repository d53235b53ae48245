// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The index space of one block written in the indices of its neighbour: a signed permutation and an offset.
#include "core/grid/extents.hpp"

namespace core {

struct IndexMap {
    std::array<int, 3> axis{0, 1, 2}; ///< axis of the other block that follows axis m of this one
    std::array<int, 3> sign{1, 1, 1};
    Index3 offset;

    [[nodiscard]] Index3 operator()(Index3 c) const
    {
        Index3 other = offset;
        for (int m = 0; m < 3; ++m) other[axis[std::size_t(m)]] += sign[std::size_t(m)] * c[m];
        return other;
    }

    [[nodiscard]] IndexMap inverse() const
    {
        IndexMap back;
        for (int m = 0; m < 3; ++m) {
            const int n = axis[std::size_t(m)];
            back.axis[std::size_t(n)] = m;
            back.sign[std::size_t(n)] = sign[std::size_t(m)];
            back.offset[m] = -sign[std::size_t(m)] * offset[n];
        }
        return back;
    }
};

} // namespace core
