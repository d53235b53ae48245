// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sums over all cells whose bits do not depend on the number of ranks: one partial sum for each block, then the blocks
// in the order of their ids.
#include "core/comm/communicator.hpp"
#include "core/grid/mesh.hpp"
#include <numeric>

namespace core {

/// Sum over all blocks of the domain of term(local block). Collective.
template <class Term>
[[nodiscard]] double sum_over_blocks(const Mesh& mesh, const Communicator& communicator, Term term)
{
    std::vector<double> parts(std::size_t(mesh.blocks()), 0.0);
    for (LocalBlock b = 0; b < mesh.own_count(); ++b) parts[std::size_t(mesh.global(b))] = term(b);
    if (communicator.size() > 1) communicator.sum(parts);
    return std::accumulate(parts.begin(), parts.end(), 0.0);
}

/// Largest of term(local block) over all blocks of the domain. Collective.
template <class Term>
[[nodiscard]] double max_over_blocks(const Mesh& mesh, const Communicator& communicator, Term term)
{
    double largest = -std::numeric_limits<double>::infinity();
    for (LocalBlock b = 0; b < mesh.own_count(); ++b) largest = std::max(largest, double(term(b)));
    communicator.max(std::span(&largest, 1));
    return largest;
}

} // namespace core
