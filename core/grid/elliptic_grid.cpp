// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/elliptic_grid.hpp"
#include "core/base/error.hpp"
#include "core/grid/topology.hpp"
#include "core/grid/wall_layers.hpp"
#include <algorithm>

namespace core {
namespace {

/// What each side of each block is asked, [block][side].
using Requests = std::vector<std::array<std::optional<WallSpacing>, 6>>;

/// The side of the block beyond `beyond` that goes on where side `side` of this block ends.
Side continued(const Neighbour& beyond, Side side)
{
    const auto axis = std::size_t(axis_of(side));
    return side_of(beyond.map.axis[axis], (beyond.map.sign[axis] > 0) == is_high(side));
}

/// Asks for a spacing at a side and at all sides that continue it; the smaller first cell wins.
void ask(const Topology& topology, BlockId block, const WallSpacing& wall, Requests& requests)
{
    auto& here = requests[std::size_t(block)][std::size_t(wall.side)];
    if (here && here->first_cell <= wall.first_cell) return;
    here = wall;
    for (const Side across : all_sides) {
        const auto& beyond = topology.neighbour(block, across);
        if (axis_of(across) == axis_of(wall.side) || !beyond) continue;
        ask(topology, beyond->block, {continued(*beyond, wall.side), wall.first_cell, wall.growth}, requests);
    }
}

std::vector<const Boundary*> sides_named(const Topology& topology, const std::string& name)
{
    std::vector<const Boundary*> sides;
    for (const Boundary& b : topology.boundaries)
        if (b.name == name) sides.push_back(&b);
    require<ConfigError>(!sides.empty(), text("no boundary of the grid is called '", name, "'"));
    return sides;
}

std::vector<Elliptic> wanted_of_blocks(const Topology& topology, const EllipticGrid& wanted)
{
    Requests requests(topology.cells.size());
    for (const BoundarySpacing& spacing : wanted.spacings)
        for (const Boundary* b : sides_named(topology, spacing.boundary))
            ask(topology, b->block, {b->side, spacing.first_cell, spacing.growth}, requests);
    std::vector<Elliptic> blocks(topology.cells.size());
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        blocks[b].curvature = wanted.curvature;
        for (const auto& request : requests[b])
            if (request) blocks[b].spacings.push_back(*request);
    }
    for (const BlockAttraction& a : wanted.attractions) {
        require<ConfigError>(a.block >= 0 && a.block < BlockId(blocks.size()),
                             text("there is no block ", a.block, ", only 0 to ", blocks.size() - 1));
        blocks[std::size_t(a.block)].attractions.push_back(a.attraction);
    }
    return blocks;
}

/// Calls what may fail, and adds the block to what it says.
template <class Body>
auto with_block(BlockId block, Body body)
{
    try {
        return body();
    } catch (const ConfigError& error) {
        throw ConfigError(text("block ", block, ": ", error.what()));
    }
}

} // namespace

std::vector<EllipticResult> make_elliptic(MultiBlock& grid, const EllipticGrid& wanted)
{
    const Topology topology = match_sides(grid);
    const auto blocks = wanted_of_blocks(topology, wanted);
    for (std::size_t b = 0; b < blocks.size(); ++b) with_block(BlockId(b), [&] { respace_lines(grid.blocks[b], blocks[b].spacings); });
    for (const std::string& name : wanted.smoothed)
        for (const Boundary* side : sides_named(topology, name))
            with_block(side->block, [&] {
                const auto b = std::size_t(side->block);
                make_elliptic_side(grid.blocks[b], side->side, blocks[b]);
            });
    require<ConfigError>(
        match_sides(grid).interfaces.size() == topology.interfaces.size(),
        "sides of blocks that met do not meet any more once their lines are spaced: blocks that touch disagree about them");
    std::vector<EllipticResult> results;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        results.push_back(with_block(BlockId(b), [&] { return solve_elliptic(grid.blocks[b], blocks[b]); }));
    return results;
}

} // namespace core
