// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/level_bins.hpp"

namespace core {

LevelBins make_level_bins(const Domain& domain, const Bounds& bounds, const SizeLevels& sizes, double skin, std::int64_t particles)
{
    LevelBins bins{sizes, {}};
    for (int level = 0; level < sizes.count(); ++level)
        bins.lattice.push_back(make_bin_lattice(domain, bounds, 2.0 * sizes.greatest(level) + skin, particles));
    return bins;
}

} // namespace core
