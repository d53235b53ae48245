// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_mesh.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace physics {
namespace {

bool links_with_itself(const BlockLink& l) { return l.a.block == l.b.block && l.a.cell == l.b.cell; }
bool before(const BlockLink& l, const BlockLink& r) { return std::tie(l.a, l.b) < std::tie(r.a, r.b); }
bool same(const BlockLink& l, const BlockLink& r) { return l.a == r.a && l.b == r.b; }

BlockLink ordered(BlockLink l)
{
    const bool wall_first = l.a.block == wall_block, wall_second = l.b.block == wall_block;
    if (wall_first || (!wall_second && l.b < l.a)) std::swap(l.a, l.b);
    if (l.b.block == wall_block) l.b = {wall_block, 0, l.a.side};
    return l;
}

/// Where ends of links lie in the flat arrays of this rank.
class Places {
public:
    explicit Places(const BlockTopology& t) : topology_(t), local_(t.cells.size(), -1)
    {
        for (std::size_t b = 0; b < t.cells.size(); ++b)
            if (t.owner[b] == t.rank) {
                local_[b] = int(ids.size());
                ids.push_back(int(b));
                cells.push_back(t.cells[b]);
            }
        for (const auto& l : t.links)
            for (const auto& end : {l.a, l.b})
                if (end.block != wall_block && local(end.block) < 0) ghosts.try_emplace({owner(end.block), end.block, end.cell}, 0);
        int n = 0;
        for (auto& ghost : ghosts) ghost.second = n++;
    }
    [[nodiscard]] int owner(core::BlockId b) const { return topology_.owner[std::size_t(b)]; }
    [[nodiscard]] core::LocalBlock local(core::BlockId b) const { return b == wall_block ? -1 : local_[std::size_t(b)]; }
    [[nodiscard]] int flat(const BlockLayout& layout, const LinkEnd& end) const
    {
        if (end.block == wall_block) return 0; // padding
        const auto b = local(end.block);
        if (b >= 0) return int(layout.origin(b)) + end.cell;
        return int(layout.ghost_origin()) + ghosts.at({owner(end.block), end.block, end.cell});
    }

    std::vector<core::BlockId> ids;
    std::vector<core::Extents> cells;
    std::map<std::tuple<int, core::BlockId, int>, int> ghosts; // (rank, block, cell) -> number

private:
    const BlockTopology& topology_;
    std::vector<core::LocalBlock> local_;
};

struct SortedHalf {
    HalfLink half;
    LinkEnd own, beyond;
    core::LocalBlock block;
};

std::vector<SortedHalf> sorted_halves(const BlockTopology& topology, const Places& places, const BlockLayout& layout)
{
    std::vector<SortedHalf> result;
    for (std::size_t l = 0; l < topology.links.size(); ++l) {
        const auto& link = topology.links[l];
        const auto add = [&](const LinkEnd& own, const LinkEnd& beyond) {
            const auto b = places.local(own.block);
            if (b >= 0) result.push_back({{places.flat(layout, own), places.flat(layout, beyond), int(l), -1}, own, beyond, b});
        };
        add(link.a, link.b);
        add(link.b, link.a);
    }
    std::stable_sort(result.begin(), result.end(), [](const SortedHalf& l, const SortedHalf& r) {
        return std::tie(l.half.cell, l.own.side, l.beyond) < std::tie(r.half.cell, r.own.side, r.beyond);
    });
    return result;
}

void add_runs(const std::vector<SortedHalf>& sorted, LevelMesh& mesh)
{
    for (std::size_t h = 0; h < sorted.size(); ++h) {
        if (h == 0 || sorted[h].own != sorted[h - 1].own)
            mesh.runs.push_back({sorted[h].block, sorted[h].own.cell, sorted[h].own.side, int(h), int(h)});
        mesh.runs.back().last = int(h) + 1;
    }
    for (core::LocalBlock b = 0, r = 0; b <= mesh.layout.blocks(); ++b) {
        while (r < int(mesh.runs.size()) && mesh.runs[std::size_t(r)].block < b) ++r;
        mesh.block_runs.push_back(r);
    }
}

void add_exchanges(const BlockTopology& topology, const Places& places, LevelMesh& mesh)
{
    std::map<int, GhostExchange> by_rank;
    for (const auto& [key, number] : places.ghosts) {
        auto& e = by_rank[std::get<0>(key)];
        if (e.ghosts++ == 0) e.receive = mesh.layout.ghost_origin() + number;
    }
    for (std::size_t l = 0; l < topology.links.size(); ++l) {
        const auto& link = topology.links[l];
        if (link.b.block == wall_block) continue;
        const bool a_here = places.local(link.a.block) >= 0, b_here = places.local(link.b.block) >= 0;
        if (a_here == b_here) continue;
        auto& e = by_rank[places.owner(a_here ? link.b.block : link.a.block)];
        e.send.push_back(places.flat(mesh.layout, a_here ? link.a : link.b));
        e.links.push_back(int(l));
    }
    for (auto& [rank, e] : by_rank) {
        e.rank = rank;
        std::sort(e.send.begin(), e.send.end());
        e.send.erase(std::unique(e.send.begin(), e.send.end()), e.send.end());
        mesh.exchanges.push_back(std::move(e));
    }
}

} // namespace

std::vector<BlockLink> canonical_links(const std::vector<BlockLink>& links, std::vector<int>& source)
{
    std::vector<BlockLink> turned;
    turned.reserve(links.size());
    source.clear();
    for (std::size_t l = 0; l < links.size(); ++l) {
        turned.push_back(ordered(links[l]));
        if (!links_with_itself(turned.back())) source.push_back(int(l));
    }
    std::stable_sort(source.begin(), source.end(), [&](int l, int r) { return before(turned[std::size_t(l)], turned[std::size_t(r)]); });
    std::vector<BlockLink> result;
    for (int l : source) result.push_back(turned[std::size_t(l)]);
    return result;
}

LevelMesh make_level_mesh(const BlockTopology& topology)
{
    const Places places(topology);
    LevelMesh mesh(BlockLayout(places.ids, places.cells, places.ghosts.size()), topology.links);
    const auto sorted = sorted_halves(topology, places, mesh.layout);
    mesh.half_of.assign(mesh.links.size(), {-1, -1});
    mesh.halves.reserve(sorted.size());
    for (const auto& s : sorted) {
        const bool is_a = mesh.links[std::size_t(s.half.link)].a == s.own;
        mesh.half_of[std::size_t(s.half.link)][is_a ? 0 : 1] = int(mesh.halves.size());
        mesh.halves.push_back(s.half);
    }
    for (std::size_t h = 0; h < mesh.halves.size(); ++h) {
        const auto& ends = mesh.half_of[std::size_t(mesh.halves[h].link)];
        mesh.halves[h].partner = ends[0] == int(h) ? ends[1] : ends[0];
    }
    for (const auto& piece : mesh.layout.pieces()) {
        const auto first = std::lower_bound(mesh.halves.begin(), mesh.halves.end(), piece.begin,
                                            [](const HalfLink& h, std::ptrdiff_t begin) { return h.cell < begin; });
        mesh.piece_halves.push_back(int(first - mesh.halves.begin()));
    }
    mesh.piece_halves.push_back(int(mesh.halves.size()));
    add_runs(sorted, mesh);
    mesh.runs.shrink_to_fit();
    add_exchanges(topology, places, mesh);
    return mesh;
}

BlockTopology coarsened(const BlockTopology& fine)
{
    BlockTopology coarse{{}, fine.owner, fine.rank, {}};
    for (const auto& c : fine.cells) coarse.cells.push_back(coarsened(c));
    return coarse;
}

BlockTopology coarsened(const BlockTopology& fine, std::vector<CoarseLink>& coarse_link)
{
    BlockTopology coarse = coarsened(fine);
    const auto parent = [&](LinkEnd end) {
        if (end.block == wall_block) return end;
        const auto place = cell_place(fine.cells[std::size_t(end.block)], end.cell);
        end.cell = cell_index(coarse.cells[std::size_t(end.block)], place.i / 2, place.j / 2, place.k / 2);
        return end;
    };
    std::vector<BlockLink> parents;
    for (const auto& l : fine.links) parents.push_back(ordered({parent(l.a), parent(l.b)}));
    coarse.links = parents;
    std::sort(coarse.links.begin(), coarse.links.end(), before);
    coarse.links.erase(std::unique(coarse.links.begin(), coarse.links.end(), same), coarse.links.end());
    std::erase_if(coarse.links, links_with_itself);
    coarse.links.shrink_to_fit();
    coarse_link.clear();
    coarse_link.reserve(parents.size());
    for (std::size_t l = 0; l < parents.size(); ++l) {
        const auto found = std::lower_bound(coarse.links.begin(), coarse.links.end(), parents[l], before);
        const bool exists = found != coarse.links.end() && same(*found, parents[l]);
        coarse_link.push_back({exists ? int(found - coarse.links.begin()) : -1, parents[l].a != parent(fine.links[l].a)});
    }
    return coarse;
}

} // namespace physics
