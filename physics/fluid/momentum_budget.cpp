// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/momentum_budget.hpp"
#include "physics/fluid/cell_loops.hpp"

namespace physics {

core::Vec3 volume_sum(const core::BlockGeometry& geometry, core::VectorView<const double> q)
{
    core::Vec3 sum;
    for (int c = 0; c < 3; ++c)
        sum[c] = sum_cells([](double v, double x) { return v * x; }, geometry.volume.view(), q.component(c));
    return sum;
}

} // namespace physics
