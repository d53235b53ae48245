// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/grid_report.hpp"
#include "core/grid/quality.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numbers>

namespace io {

namespace {

using core::BlockId, core::Side;

constexpr int most_blocks_shown = 40;

/// The sides that lie on a side without matching points: "1.i_low and 2.i_low (sub-faces)".
[[nodiscard]] std::string joined(const core::Topology& topology, BlockId block, Side side)
{
    std::string text;
    for (const core::SubFaceInterface& joint : topology.joints.interfaces) {
        const core::SideContact& c = joint.contact;
        const auto add = [&](BlockId other, Side side_there) {
            text += fmt::format("{}{}.{}", text.empty() ? "" : " and ", other, core::side_words[std::size_t(side_there)]);
        };
        if (c.a == block && c.side_a == side) add(c.b, c.side_b);
        if (c.b == block && c.side_b == side) add(c.a, c.side_a);
    }
    return text + " (sub-faces)";
}

[[nodiscard]] std::string beyond(const core::Topology& topology, BlockId block, Side side)
{
    if (const auto& n = topology.neighbour(block, side))
        return fmt::format("{}.{}{}", n->block, core::side_words[std::size_t(n->side)],
                           n->motion.is_identity() ? ""
                           : n->motion.turns       ? " (turned)"
                                                   : " (periodic)");
    if (topology.joints.joins(block, side)) return joined(topology, block, side);
    const auto boundary = std::find_if(topology.boundaries.begin(), topology.boundaries.end(),
                                       [&](const core::Boundary& b) { return b.block == block && b.side == side; });
    return boundary->name;
}

[[nodiscard]] std::string line_of(const core::Topology& topology, BlockId block)
{
    const core::Extents n = topology.cells[std::size_t(block)];
    std::string line = fmt::format("  block {}: {} x {} x {} cells", block, n.ni, n.nj, n.nk);
    for (const Side side : core::all_sides)
        line +=
            fmt::format("{} {} {}", side == Side::i_low ? ";" : ",", core::side_words[std::size_t(side)], beyond(topology, block, side));
    return line;
}

[[nodiscard]] std::string at(const core::WorstCell& worst)
{
    return fmt::format("in cell ({}, {}, {}) of block {}", worst.cell.i, worst.cell.j, worst.cell.k, worst.block);
}

[[nodiscard]] std::string quality_text(const core::Mesh& mesh)
{
    std::vector<core::Vertices> blocks;
    for (BlockId b = 0; b < mesh.blocks(); ++b) blocks.push_back(mesh.vertices(b));
    const core::GridQuality q = core::quality_of(blocks, mesh.topology());
    return fmt::format("\n  smallest corner Jacobian {:.3g} of a brick's, {}", q.jacobian.value, at(q.jacobian)) +
           fmt::format("\n  largest skewness {:.1f} degrees off a right angle, {}", q.skewness.value * 180 / std::numbers::pi,
                       at(q.skewness)) +
           fmt::format("\n  largest aspect ratio {:.3g}, {}", q.aspect_ratio.value, at(q.aspect_ratio)) +
           fmt::format("\n  largest growth from cell to cell {:.3g}, {}", q.growth.value, at(q.growth));
}

} // namespace

std::string grid_report(const core::Mesh& mesh)
{
    struct Count {
        int sides = 0;
        std::ptrdiff_t faces = 0;
    };
    const core::Topology& topology = mesh.topology();
    std::map<std::string, Count> boundaries;
    for (const core::Boundary& b : topology.boundaries) {
        Count& count = boundaries[b.name];
        const core::Extents n = mesh.cells(b.block);
        ++count.sides;
        count.faces += n.size() / n[core::axis_of(b.side)];
    }
    std::string text = fmt::format("grid of {} blocks, {} pairs of sides that meet", mesh.blocks(), topology.interfaces.size());
    if (const auto& joints = topology.joints.interfaces; !joints.empty()) {
        std::size_t faces = 0;
        for (const core::SubFaceInterface& joint : joints) faces += joint.faces.size();
        text += fmt::format("\n  {} pairs of sides meet without matching points, at {} sub-faces", joints.size(), faces);
    }
    text += quality_text(mesh);
    for (const auto& [name, count] : boundaries) text += fmt::format("\n  boundary {}: {} sides, {} faces", name, count.sides, count.faces);
    for (BlockId b = 0; b < std::min(mesh.blocks(), most_blocks_shown); ++b) text += fmt::format("\n{}", line_of(topology, b));
    if (mesh.blocks() > most_blocks_shown) text += fmt::format("\n  and {} blocks more", mesh.blocks() - most_blocks_shown);
    return text;
}

} // namespace io
