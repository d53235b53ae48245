// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/line_chains.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace physics {

BlockLines::BlockLines(core::Extents cells, LineAxis line_axis)
    : axis(static_cast<int>(line_axis)),
      u(axis == 0 ? 1 : 0),
      v(axis == 2 ? 1 : 2),
      across(cells[u]),
      count(cells[u] * cells[v]),
      length(cells[axis])
{
}

core::Index3 BlockLines::end(int line, bool high) const
{
    core::Index3 c;
    c[axis] = high ? length - 1 : 0;
    c[u] = line % across;
    c[v] = line / across;
    return c;
}

LineChains::LineChains(std::vector<SidePatch> patches, const BlockTopology& level)
    : patches_(std::move(patches)),
      cells_(level.cells),
      owner_(level.owner),
      rank_(level.rank),
      tied_(patches_.size(), 0),
      lines_(cells_.size()),
      begin_(cells_.size(), -1)
{
}

bool LineChains::ties(const SidePatch& p, const std::vector<LineChoice>& choices) const
{
    constexpr double firm = 0.8; // below, the smoother comes along without: a cell gets a fifth of what it gives from elsewhere
    const auto holds = [&](core::BlockId b, core::Side side) {
        const LineChoice& c = choices[std::size_t(b)];
        return static_cast<int>(c.axis) == core::axis_of(side) && c.hold[core::is_high(side) ? 1 : 0] >= firm;
    };
    return holds(p.from, p.side) && holds(p.to, p.beyond);
}

void LineChains::join(const std::vector<LineChoice>& choices)
{
    std::vector<char> tied;
    for (const SidePatch& p : patches_) tied.push_back(ties(p, choices) ? 1 : 0);
    bool same = tied == tied_;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
        if (!same || begin_[b] < 0) continue;
        same = lines_[b].axis == static_cast<int>(choices[b].axis);
    }
    if (same) return;
    tied_ = std::move(tied);
    for (std::size_t b = 0; b < cells_.size(); ++b)
        if (choices[b].axis != LineAxis::none) lines_[b] = BlockLines(cells_[b], choices[b].axis);
    lay_out();
}

std::vector<core::BlockId> LineChains::groups() const
{
    std::vector<core::BlockId> least(cells_.size());
    std::iota(least.begin(), least.end(), 0);
    const auto root = [&](core::BlockId b) {
        while (least[std::size_t(b)] != b) b = least[std::size_t(b)];
        return b;
    };
    for (std::size_t n = 0; n < patches_.size(); ++n) {
        if (tied_[n] == 0) continue;
        const auto a = root(patches_[n].from), b = root(patches_[n].to);
        least[std::size_t(std::max(a, b))] = std::min(a, b);
    }
    for (std::size_t b = 0; b < least.size(); ++b) least[b] = root(core::BlockId(b));
    return least;
}

void LineChains::lay_out()
{
    chains_.clear();
    nodes_.clear();
    partners_.clear();
    std::vector<char> in_chain(cells_.size(), 0), mine(cells_.size(), 0);
    for (std::size_t n = 0; n < patches_.size(); ++n)
        if (tied_[n] != 0) in_chain[std::size_t(patches_[n].from)] = 1;
    const std::vector<core::BlockId> group = groups();
    for (std::size_t b = 0; b < cells_.size(); ++b)
        if (in_chain[b] != 0 && owner_[b] == rank_) mine[std::size_t(group[b])] = 1;
    int lines = 0;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
        const bool concerns = in_chain[b] != 0 && mine[std::size_t(group[b])] != 0;
        begin_[b] = concerns ? lines : -1;
        if (concerns) lines += lines_[b].count;
    }
    ports_.assign(std::size_t(port_numbers * lines), 0.0F);
    ends_.assign(std::size_t(2 * lines), 0.0F);
    std::vector<char> seen(std::size_t(lines), 0);
    for (std::size_t b = 0; b < cells_.size(); ++b) {
        if (begin_[b] < 0 || owner_[b] != rank_) continue;
        for (int line = 0; line < lines_[b].count; ++line) {
            if (seen[std::size_t(begin_[b] + line)] != 0) continue;
            bool ring = false;
            const auto chain = chain_through({core::BlockId(b), line, false}, ring);
            for (const Segment& s : chain) seen[std::size_t(begin_[std::size_t(s.block)] + s.line)] = 1;
            add_chain(chain, ring);
        }
    }
    if (!nodes_.empty()) chains_.push_back(int(nodes_.size()));
    find_partners(group);
}

void LineChains::find_partners(const std::vector<core::BlockId>& group)
{
    const auto place = [&](int rank) -> Partner& {
        const auto at = std::lower_bound(partners_.begin(), partners_.end(), rank, [](const Partner& p, int r) { return p.rank < r; });
        return at != partners_.end() && at->rank == rank ? *at : *partners_.insert(at, Partner{rank, {}, {}});
    };
    for (std::size_t a = 0; a < cells_.size(); ++a) {
        if (begin_[a] < 0 || owner_[a] == rank_) continue;
        Partner& partner = place(owner_[a]);
        partner.theirs.push_back(core::BlockId(a));
        for (std::size_t b = 0; b < cells_.size(); ++b)
            if (begin_[b] >= 0 && owner_[b] == rank_ && group[a] == group[b]) partner.mine.push_back(core::BlockId(b));
    }
    for (Partner& p : partners_) {
        std::sort(p.mine.begin(), p.mine.end());
        p.mine.erase(std::unique(p.mine.begin(), p.mine.end()), p.mine.end());
    }
}

const SidePatch* LineChains::patch_at(core::BlockId b, core::Index3 cell, core::Side side) const
{
    const auto first = std::lower_bound(patches_.begin(), patches_.end(), std::tuple(b, side),
                                        [](const SidePatch& p, const auto& wanted) { return std::tuple(p.from, p.side) < wanted; });
    for (auto p = first; p != patches_.end() && p->from == b && p->side == side; ++p)
        if (tied_[std::size_t(p - patches_.begin())] != 0 && p->contains(cell)) return &*p;
    return nullptr;
}

std::optional<LineChains::Segment> LineChains::next(const Segment& s) const
{
    const BlockLines& l = lines(s.block);
    const core::Index3 cell = l.end(s.line, !s.turned);
    const SidePatch* patch = patch_at(s.block, cell, core::side_of(l.axis, !s.turned));
    if (!patch) return std::nullopt;
    return Segment{patch->to, lines(patch->to).line(patch->across(cell)), core::is_high(patch->beyond)};
}

/// In an order that does not depend on where it is asked for: from the lesser end, a ring from its least line.
std::vector<LineChains::Segment> LineChains::chain_through(Segment s, bool& ring) const
{
    const auto place = [](const Segment& x) { return std::tie(x.block, x.line); };
    const auto walk = [&](Segment from) {
        std::vector<Segment> chain{from};
        for (auto n = next(from); n && place(*n) != place(from); n = next(*n)) chain.push_back(*n);
        return chain;
    };
    const auto turned = [](Segment x) { return Segment{x.block, x.line, !x.turned}; };
    const std::vector<Segment> there = walk(s);
    ring = next(there.back()).has_value();
    if (ring) {
        const Segment least =
            *std::min_element(there.begin(), there.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
        return walk({least.block, least.line, false});
    }
    const Segment end = turned(there.back()), other = turned(walk(end).back());
    return walk(place(other) <= place(end) ? other : end);
}

void LineChains::add_chain(const std::vector<Segment>& chain, bool ring)
{
    chains_.push_back(int(nodes_.size()));
    for (std::size_t n = 0; n < chain.size(); ++n) {
        const Segment& s = chain[n];
        const BlockLines& l = lines(s.block);
        const int begin = begin_[std::size_t(s.block)], end = 2 * begin + s.line, port = port_numbers * begin + s.line;
        const int link = n + 1 < chain.size() || ring ? port + (s.turned ? 3 : 4) * l.count : -1;
        if (l.length == 1) {
            nodes_.push_back({end, port, link});
            continue;
        }
        const int low = s.turned ? l.count : 0, high = l.count - low;
        nodes_.push_back({end + low, port + low, port + 2 * l.count});
        nodes_.push_back({end + high, port + high, link});
    }
}

} // namespace physics
