// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/exact_sums.hpp"
#include <algorithm>
#include <cmath>

namespace io {

std::vector<double> exact_sums(const core::Communicator& ranks, const std::vector<std::vector<double>>& columns)
{
    constexpr int bits = 40; // of each of the two integers that carry a value
    std::vector<double> largest(columns.size(), 0.0);
    for (std::size_t c = 0; c < columns.size(); ++c)
        for (const double x : columns[c]) largest[c] = std::max(largest[c], std::abs(x));
    ranks.max(largest);
    std::vector<int> exponents(columns.size(), 0);
    std::vector<std::int64_t> parts(2 * columns.size(), 0);
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (largest[c] > 0) exponents[c] = std::ilogb(largest[c]) + 1;
        for (const double x : columns[c]) {
            const double scaled = std::ldexp(x, bits - exponents[c]), whole = std::trunc(scaled);
            parts[2 * c] += std::int64_t(whole);
            parts[2 * c + 1] += std::int64_t(std::trunc(std::ldexp(scaled - whole, bits)));
        }
    }
    ranks.sum(parts);
    std::vector<double> sums;
    for (std::size_t c = 0; c < columns.size(); ++c)
        sums.push_back(std::ldexp(double(parts[2 * c]), exponents[c] - bits) +
                       std::ldexp(double(parts[2 * c + 1]), exponents[c] - 2 * bits));
    return sums;
}

} // namespace io
