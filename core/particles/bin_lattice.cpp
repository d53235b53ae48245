// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/bin_lattice.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace core {

std::int64_t BinLattice::along(int axis, double x) const
{
    const auto last = count[std::size_t(axis)] - 1;
    const double place = (x - low[axis]) / width[axis];
    return place <= 0.0 ? 0 : place >= double(last) ? last : std::int64_t(place);
}

Bin BinLattice::from_key(std::int64_t key) const
{
    Bin b{};
    for (const int axis : {order[2], order[1], order[0]}) {
        b[std::size_t(axis)] = key % count[std::size_t(axis)];
        key /= count[std::size_t(axis)];
    }
    return b;
}

BinLattice make_bin_lattice(const Domain& domain, const Bounds& bounds, double cutoff, std::int64_t particles)
{
    BinLattice lattice;
    lattice.periodic = domain.periodic;
    if (particles == 0) return lattice;
    Vec3 extent;
    for (int a = 0; a < 3; ++a) {
        const bool periodic = domain.periodic[std::size_t(a)];
        require<ConfigError>(!periodic || domain.size[a] >= 2.0 * cutoff,
                             text("periodic length ", domain.size[a], " m along axis ", a, " is below twice the neighbour distance ",
                                  cutoff, " m: make the domain longer"));
        lattice.low[a] = periodic || bounds.low[a] > bounds.high[a] ? 0.0 : bounds.low[a];
        extent[a] = periodic ? domain.size[a] : std::max(0.0, bounds.high[a] - bounds.low[a]);
    }
    const std::int64_t most = std::max<std::int64_t>(4096, 2 * particles);
    for (double wanted = cutoff;; wanted *= 1.26) {
        double bins = 1.0;
        for (std::size_t a = 0; a < 3; ++a) {
            const double n = std::max(1.0, std::floor(extent[int(a)] / wanted));
            bins *= n;
            lattice.count[a] = std::int64_t(std::min(n, 1e6));
            lattice.width[int(a)] = std::max(extent[int(a)] / n, wanted * (lattice.periodic[a] ? 0.0 : 1.0));
        }
        if (bins <= double(most)) break;
    }
    std::sort(lattice.order.begin(), lattice.order.end(), [&](int a, int b) {
        const auto na = lattice.count[std::size_t(a)], nb = lattice.count[std::size_t(b)];
        return na != nb ? na > nb : a > b;
    });
    return lattice;
}

} // namespace core
