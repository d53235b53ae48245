// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One level of the multigrid hierarchy: its mesh, its 32-bit coefficients and vectors.
#include "physics/fluid/line_chains.hpp"
#include "physics/fluid/seven_point.hpp"
#include <array>
#include <vector>

namespace physics {

/// Which smoother a block uses.
enum class Smoother {
    automatic, ///< lines where the coefficients are anisotropic, else points
    point,
    line
};

/// Flat places, on the finer level, of the children next to the side of a run.
struct SideChildren {
    int count = 0;
    std::array<int, 4> at{};
};

struct MultigridLevel {
    explicit MultigridLevel(LevelMesh m) : mesh(std::move(m)) {}

    LevelMesh mesh;
    SevenPoint<float> matrix;
    std::vector<LineAxis> axis;                       ///< of each block
    bool has_lines = false;                           ///< some block has an axis
    LineChains chains;                                ///< of lines that go on in other blocks
    std::vector<LineChoice> choices;                  ///< of all blocks on whatever rank
    bool is_shared = false;                           ///< each rank has blocks of its own, not all of them
    bool lines_are_firm = false;                      ///< some block is so anisotropic that nothing may be left along its lines
    std::vector<float> from_low, from_high;           ///< shares of the ends of a line in the values along it; empty without chains
    std::vector<float> inverse;                       ///< 1 / diagonal, or 1 / pivot of the line factorisation
    std::vector<std::array<float, 2>> end_resistance; ///< of each link: half a cell of the next level, at either end
    std::vector<float> right, residual, direction, solution, other;
    /// How much of the difference to the neighbour beyond each side (see core::Side) the children next to it take.
    std::array<std::vector<float>, 6> weight;
    std::vector<float> half_weight;              ///< the same for what lies beyond a half link
    std::array<std::vector<float>, 6> side_part; ///< residual that goes to the neighbour beyond each side
    std::vector<float> half_part;                ///< residual that goes beyond a half link
    std::vector<float> half_received;            ///< the same from partners on other ranks
    std::vector<SideChildren> side_children;     ///< of each run whose block has a finer one here
    std::vector<int> owner;                      ///< rank of each block, only on the first level that every rank holds as a whole
    std::vector<int> fine_block;                 ///< block of the next finer level, -1 where that is not on this rank
    std::vector<int> coarse_block;               ///< block of the next coarser level

    /// Do lines of this block go on in others?
    [[nodiscard]] bool in_chains(core::LocalBlock b) const { return chains.has(mesh.layout.id(b)); }
    [[nodiscard]] std::size_t bytes() const
    {
        const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
        std::size_t sum = of(matrix.shift) + of(matrix.link) + of(matrix.half) + of(inverse) + of(end_resistance) + of(right) +
                          of(residual) + of(direction) + of(solution) + of(other) + of(mesh.links) + of(mesh.halves) + of(mesh.half_of) +
                          of(mesh.runs) + of(mesh.coarse_link);
        sum += of(from_low) + of(from_high) + chains.bytes();
        for (const auto& f : matrix.face) sum += of(f);
        for (std::size_t n = 0; n < 6; ++n) sum += of(weight[n]) + of(side_part[n]);
        sum += of(half_weight) + of(half_part) + of(half_received) + of(side_children);
        return sum;
    }
};

/// Collective.
/// @param ranks  That share the blocks: self() where each has all.
[[nodiscard]] MultigridLevel make_multigrid_level(const BlockTopology& topology, bool with_shift, const core::Communicator& ranks);
/// Ties a level to the next coarser one: blocks by their ids, memory for the transfer.
void tie_levels(MultigridLevel& fine, MultigridLevel& coarse);
/// Gives back the memory of a coarse level that is not in use: of its coefficients and vectors.
void release(MultigridLevel& coarse);
/// Makes a coarse level as it was before release(), all zero.
void restore(bool with_shift, MultigridLevel& coarse);

} // namespace physics
