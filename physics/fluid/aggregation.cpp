// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/aggregation.hpp"

#include <numeric>

namespace physics {

bool holds_together(std::span<const double> sums, const AggregateTies& ties, double bound)
{
    // L - 2 / bound (D - d d^T / sum of d) must have no negative eigenvalue. It has a null space, the constants: the heaviest node
    // is left out, the rest eliminated, and what vanishes within round-off counts as positive.
    constexpr double round_off = 1e-6; // of 32-bit coefficients
    const double share = 2.0 / bound, all = std::accumulate(sums.begin(), sums.end(), 0.0);
    const auto heaviest = std::size_t(std::max_element(sums.begin(), sums.end()) - sums.begin());
    std::array<std::size_t, most_joined> node{};
    std::size_t n = 0;
    for (std::size_t m = 0; m < sums.size(); ++m)
        if (m != heaviest) node[n++] = m;
    AggregateTies a;
    for (std::size_t r = 0; r < n; ++r) {
        for (std::size_t c = 0; c < n; ++c)
            a[r][c] = share * sums[node[r]] * sums[node[c]] / all - (r == c ? share * sums[node[r]] : ties[node[r]][node[c]]);
        for (std::size_t m = 0; m < sums.size(); ++m)
            if (m != node[r]) a[r][r] += ties[node[r]][m];
    }
    for (std::size_t r = 0; r < n; ++r) {
        const double least = round_off * sums[node[r]];
        if (a[r][r] <= -least) return false;
        const double reciprocal = 1.0 / std::max(a[r][r], least);
        for (std::size_t k = r + 1; k < n; ++k)
            for (std::size_t c = r + 1; c < n; ++c) a[k][c] -= a[k][r] * reciprocal * a[r][c];
    }
    return true;
}

} // namespace physics
