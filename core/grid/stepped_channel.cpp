// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/stepped_channel.hpp"
#include "core/base/error.hpp"
#include "core/grid/box.hpp"
#include "core/grid/touching_blocks.hpp"

namespace core {
namespace {

/// Shallow, deep below the step, deep above it.
std::array<Box, 3> parts(const SteppedChannel& c)
{
    const auto part = [&](int along, int up) {
        Box box;
        box.low = {along == 0 ? 0.0 : c.shallow_length, up == 0 ? 0.0 : c.step, 0};
        box.high = {along == 0 ? c.shallow_length : c.shallow_length + c.deep_length, up == 0 ? c.step : c.step + c.height, c.width};
        box.cells = {c.cells_along[std::size_t(along)], c.cells_up[std::size_t(up)], c.cells_across};
        if (along == 1 && up == 1) box.cells.nj = c.deep_cells_up.value_or(box.cells.nj);
        if (along == 1) box.cells.nk = c.deep_cells_across.value_or(box.cells.nk);
        box.blocks = {c.blocks_along[std::size_t(along)], 1, c.blocks_across};
        return box;
    };
    return {part(0, 1), part(1, 0), part(1, 1)};
}

} // namespace

MultiBlock make_stepped_channel(const SteppedChannel& c)
{
    for (const double length : {c.shallow_length, c.deep_length, c.height, c.step, c.width})
        require<ConfigError>(length > 0, "all lengths of a stepped channel must be positive");
    MultiBlock grid;
    std::vector<int> part_of;
    const auto boxes = parts(c);
    for (int part = 0; part < 3; ++part)
        for (auto& block : make_box(boxes[std::size_t(part)]).blocks) {
            grid.blocks.push_back(std::move(block));
            part_of.push_back(part);
        }
    if (c.periodic_along) grid.periods.push_back((c.shallow_length + c.deep_length) * Vec3::UnitX());
    if (c.periodic_across) grid.periods.push_back(c.width * Vec3::UnitZ());
    grid.boundary_name = [part_of](BlockId block, Side s) {
        const bool below_step = part_of[std::size_t(block)] == 1;
        if (below_step && s == Side::i_low) return std::string("step");
        return std::string(1, char('x' + axis_of(s))) + (is_high(s) ? "_high" : "_low");
    };
    if (c.deep_cells_up || c.deep_cells_across) join_touching_blocks(grid);
    return grid;
}

} // namespace core
