// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/spacing.hpp"
#include "core/base/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace core {
namespace {

/// Sizes that growth from the ends allows.
std::vector<double> allowed_sizes(int cells, const EndSpacing& ends)
{
    std::vector<double> sizes(std::size_t(cells), std::numeric_limits<double>::infinity());
    double low = ends.low.value_or(0), high = ends.high.value_or(0);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (ends.low) sizes[i] = std::min(sizes[i], low);
        if (ends.high) sizes[sizes.size() - 1 - i] = std::min(sizes[sizes.size() - 1 - i], high);
        low *= ends.growth;
        high *= ends.growth;
    }
    return sizes;
}

/// Sum of the sizes where none may exceed `largest`.
double sum_of(const std::vector<double>& sizes, double largest)
{
    double sum = 0;
    for (const double size : sizes) sum += std::min(size, largest);
    return sum;
}

} // namespace

std::vector<double> spaced(int cells, double length, const EndSpacing& ends)
{
    constexpr int bisections = 60; // down to the last bit
    const std::vector<double> sizes = allowed_sizes(cells, ends);
    double low = 0, high = length;
    const double most = sum_of(sizes, high);
    require<ConfigError>(most >= length * (1 - 1e-12),
                         text(cells, " cells that grow by ", ends.growth, " from ", ends.low ? text(*ends.low, " m") : "",
                              ends.low && ends.high ? " and " : "", ends.high ? text(*ends.high, " m") : "", " fill ", most, " m of ",
                              length, " m: let them grow faster, or take more or larger cells"));
    for (int n = 0; n < bisections; ++n) {
        const double middle = 0.5 * (low + high);
        (sum_of(sizes, middle) < length ? low : high) = middle;
    }
    std::vector<double> shares{0.0};
    for (const double size : sizes) shares.push_back(shares.back() + std::min(size, high));
    for (double& s : shares) s /= shares.back();
    return shares;
}

} // namespace core
