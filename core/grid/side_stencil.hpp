// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Interpolation in a layer of cells along a side of a block, as values beyond sides without matching points need it.
#include "core/grid/halo_map.hpp"

namespace core {

enum class LayerWeights {
    cubic, ///< where two cells lie on either side along each axis, else of a lower order; linear beyond the last cell
    linear ///< none of them negative; constant beyond the last cell
};

/// Cells and weights that interpolate to a place in the layer of cells next to its side (layer 0) or deeper. Across sides that
/// match the stencil goes on in the next block. The weights add up to 1.
/// @param place  Its motion begins those of the sources.
/// @return None where the block has no such layer, nor a neighbour beyond it with matching points.
[[nodiscard]] std::vector<HaloSource> layer_stencil(const Topology& topology, const SidePlace& place, int layer,
                                                    LayerWeights weights = LayerWeights::cubic);

} // namespace core
