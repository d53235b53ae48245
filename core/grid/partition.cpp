// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/partition.hpp"
#include <algorithm>
#include <cstdint>

namespace core {

std::vector<int> partition(std::span<const Extents> cells, int ranks)
{
    std::int64_t total = 0;
    for (const Extents e : cells) total += e.size();
    std::vector<int> owner;
    std::int64_t before = 0;
    for (const Extents e : cells) {
        const std::int64_t middle = before + e.size() / 2;
        owner.push_back(int(std::min<std::int64_t>(ranks - 1, middle * ranks / std::max<std::int64_t>(1, total))));
        before += e.size();
    }
    return owner;
}

} // namespace core
