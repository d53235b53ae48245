// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/side_patches.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>
#include <tuple>

namespace physics {
namespace {

/// A link as one of its cells sees it.
struct Facing {
    LinkEnd own, beyond;
    [[nodiscard]] auto sides() const { return std::tie(own.block, own.side, beyond.block, beyond.side); }
    bool operator<(const Facing& other) const
    {
        return std::tuple_cat(sides(), std::tie(own.cell, beyond.cell)) <
               std::tuple_cat(other.sides(), std::tie(other.own.cell, other.beyond.cell));
    }
};

/// All ends on this rank, sorted by the two sides and then by cell.
std::vector<Facing> facings(const BlockTopology& level)
{
    std::vector<Facing> result;
    const auto add = [&](const LinkEnd& own, const LinkEnd& beyond) {
        if (own.block != wall_block && level.owner[std::size_t(own.block)] == level.rank) result.push_back({own, beyond});
    };
    for (const BlockLink& l : level.links) {
        add(l.a, l.b);
        add(l.b, l.a);
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// Cells with one link only: what meets several cells has no line to go on in.
std::vector<Facing> alone(std::vector<Facing> all)
{
    std::vector<LinkEnd> ends;
    for (const Facing& f : all) ends.push_back(f.own);
    std::sort(ends.begin(), ends.end());
    std::erase_if(all, [&](const Facing& f) {
        const auto [first, last] = std::equal_range(ends.begin(), ends.end(), f.own);
        return last - first > 1 || f.beyond.block == wall_block;
    });
    return all;
}

/// The patch that all facings of two sides form; none if they are no rectangle or lie on each other in no regular way.
std::optional<SidePatch> patch_of(std::span<const Facing> facing, core::Extents from, core::Extents to)
{
    const Facing& first = facing.front();
    SidePatch p{first.own.block, first.beyond.block, first.own.side, first.beyond.side, {}, {}, {}, {}};
    p.low = cell_place(from, first.own.cell);
    p.high = cell_place(from, facing.back().own.cell);
    for (int axis = 0; axis < 3; ++axis) ++p.high[axis];
    p.base = cell_place(to, first.beyond.cell);
    const core::Extents n{p.high.i - p.low.i, p.high.j - p.low.j, p.high.k - p.low.k};
    if (n.ni < 1 || n.nj < 1 || n.nk < 1 || n.size() != std::ptrdiff_t(facing.size())) return std::nullopt;
    const std::array<int, 3> stride{1, n.ni, n.ni * n.nj};
    for (int axis = 0; axis < 3; ++axis) {
        if (n[axis] < 2) continue;
        const auto next = cell_place(to, facing[std::size_t(stride[std::size_t(axis)])].beyond.cell);
        for (int m = 0; m < 3; ++m) p.step[std::size_t(axis)][m] = next[m] - p.base[m];
    }
    const bool regular = std::all_of(facing.begin(), facing.end(), [&](const Facing& f) {
        const auto c = cell_place(from, f.own.cell);
        return p.contains(c) && p.across(c) == cell_place(to, f.beyond.cell);
    });
    return regular ? std::optional(p) : std::nullopt;
}

auto key(const SidePatch& p) { return std::tuple(p.from, p.side, p.to, p.beyond); }

} // namespace

std::vector<SidePatch> side_patches(const BlockTopology& level, const core::Communicator& ranks)
{
    const std::vector<Facing> all = alone(facings(level));
    std::vector<SidePatch> mine, result;
    for (auto first = all.begin(); first != all.end();) {
        const auto last = std::find_if(first, all.end(), [&](const Facing& f) { return f.sides() != first->sides(); });
        const auto cells = [&](const LinkEnd& end) { return level.cells[std::size_t(end.block)]; };
        if (const auto patch = patch_of({first, last}, cells(first->own), cells(first->beyond))) mine.push_back(*patch);
        first = last;
    }
    std::vector<SidePatch> seen;
    for (const auto& bytes : ranks.gather_all(std::as_bytes(std::span(mine)))) {
        const auto old = seen.size(), count = bytes.size() / sizeof(SidePatch);
        seen.resize(old + count);
        if (count > 0) std::memcpy(seen.data() + old, bytes.data(), bytes.size());
    }
    std::sort(seen.begin(), seen.end(), [](const SidePatch& l, const SidePatch& r) { return key(l) < key(r); });
    for (const SidePatch& p : seen) { // both blocks must see it, and as large
        const auto turned = std::tuple(p.to, p.beyond, p.from, p.side);
        const auto back =
            std::lower_bound(seen.begin(), seen.end(), turned, [](const SidePatch& l, const auto& wanted) { return key(l) < wanted; });
        if (back != seen.end() && key(*back) == turned && back->size() == p.size() && back->contains(p.base) &&
            back->across(p.base) == p.low)
            result.push_back(p);
    }
    return result;
}

} // namespace physics
