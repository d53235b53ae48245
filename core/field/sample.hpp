// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Linear hats over the cell centres in mapped space: the same weights sample a field at a point and deposit a quantity
// of the point in the cells, so that the two are transposes of each other (NUMERICS B3, B6).
#include "core/field/field.hpp"
#include "core/grid/locate.hpp"

namespace core {

/// The eight cell centres round a point and the place among them: half way at the face between two cells; beside a side without
/// matching points, where the cells beyond are of another size, as linear interpolation to the face has it. The cells may lie in the
/// first halo layer.
struct HatStencil {
    LocalBlock block = -1;
    Index3 base;                ///< lowest of the eight cells
    std::array<double, 3> part; ///< in [0, 1) along i, j, k
};

/// @pre at.block is a block of this rank.
[[nodiscard]] HatStencil hat_stencil(const Mesh& mesh, const Location& at);

/// Calls use(i, j, k, weight) for the eight cells, in a fixed order.
template <class Use>
void for_each_hat(const HatStencil& s, Use use)
{
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const double weight = (i ? s.part[0] : 1 - s.part[0]) * (j ? s.part[1] : 1 - s.part[1]) * (k ? s.part[2] : 1 - s.part[2]);
                use(s.base.i + i, s.base.j + j, s.base.k + k, weight);
            }
}

/// Value of a cell field at the point. The first halo layer must be filled, walls included (mirror_even).
[[nodiscard]] inline double sample(const HatStencil& s, View<const double> field)
{
    double sum = 0;
    for_each_hat(s, [&](int i, int j, int k, double weight) { sum += weight * field(i, j, k); });
    return sum;
}

/// Adds `quantity` to the cells round the point; what falls in halos must be sent home afterwards.
inline void deposit(const HatStencil& s, double quantity, View<double> field)
{
    for_each_hat(s, [&](int i, int j, int k, double weight) { field(i, j, k) += weight * quantity; });
}

/// Fills the first halo layer beyond the boundaries of a block with the value inside: no gradient at walls.
void mirror_even(const Mesh& mesh, LocalBlock block, View<double> field);
/// The transpose: what lies beyond boundaries is added inside, in a fixed order, and zeroed.
void mirror_even_transpose(const Mesh& mesh, LocalBlock block, View<double> field);

} // namespace core
