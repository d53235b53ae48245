// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Means over the domain.
#include "core/comm/reduce.hpp"
#include "core/grid/mesh.hpp"
#include <functional>

namespace test {

using OfCell = std::function<double(core::LocalBlock b, int i, int j, int k)>;

/// Volume mean of a value in each cell.
[[nodiscard]] inline double volume_mean(const core::Mesh& mesh, const core::Communicator& ranks, const OfCell& value)
{
    const auto of_block = [&](core::LocalBlock b) {
        const auto volume = mesh.geometry(b).volume.view();
        double sum = 0;
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) { sum += volume(i, j, k) * value(b, i, j, k); });
        return sum;
    };
    return core::sum_over_blocks(mesh, ranks, of_block) / mesh.total_volume();
}

} // namespace test
