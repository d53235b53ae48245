// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/aggregate_levels.hpp"

#include "physics/fluid/graph_cycle.hpp"

namespace physics {
namespace {

/// A block of the finest level as PairwiseAggregation wants it: cells may be joined with those inside the block.
class GraphOfBlock {
public:
    /// @param sums  Of the coefficients of each cell, flat.
    GraphOfBlock(const MultigridLevel& level, core::LocalBlock b, const std::vector<float>& sums)
        : level_(level), cells_(level.mesh.layout.cells(b)), origin_(level.mesh.layout.origin(b)), sums_(sums)
    {
    }
    [[nodiscard]] int nodes() const { return int(cells_.size()); }
    [[nodiscard]] double sum(int n) const { return sums_[std::size_t(origin_ + n)]; }
    [[nodiscard]] double shift(int n) const { return level_.matrix.shift.empty() ? 0.0 : level_.matrix.shift[std::size_t(origin_ + n)]; }
    [[nodiscard]] bool is_at_side(int n) const
    {
        const core::Index3 place = cell_place(cells_, n);
        const auto ends = [&](int axis) { return place[axis] == 0 || place[axis] + 1 == cells_[axis]; };
        return ends(0) || ends(1) || ends(2);
    }
    template <class Body>
    void for_each(int n, Body body) const
    {
        const std::array<int, 3> stride{1, cells_.ni, cells_.ni * cells_.nj};
        const core::Index3 place = cell_place(cells_, n);
        for (int axis = 0; axis < 3; ++axis) {
            const float* t = level_.matrix.face[std::size_t(axis)].data() + origin_ + n;
            const int s = stride[std::size_t(axis)];
            if (place[axis] > 0) body(n - s, double(t[0]));
            if (place[axis] + 1 < cells_[axis]) body(n + s, double(t[s]));
        }
    }

private:
    const MultigridLevel& level_;
    core::Extents cells_;
    std::ptrdiff_t origin_;
    const std::vector<float>& sums_;
};

/// body(flat place, conductance) for all that a cell is tied to over the sides of its block.
template <class Body>
void for_each_link(const MultigridLevel& level, std::ptrdiff_t cell, Body body)
{
    const auto& halves = level.mesh.halves;
    auto half = std::lower_bound(halves.begin(), halves.end(), cell, [](const HalfLink& h, std::ptrdiff_t c) { return h.cell < c; });
    for (; half != halves.end() && half->cell == cell; ++half)
        body(std::size_t(half->other), double(level.matrix.half[std::size_t(half - halves.begin())]));
}

} // namespace

void AggregateLevels::join_cells(const core::Team& team, MultigridLevel& finest)
{
    const BlockLayout& layout = finest.mesh.layout;
    constexpr double bound = 11.0; // of condition numbers: 10 takes no iteration less, and more memory and time; with 14 layers take 24
    layout.for_pieces(team, [&](int n) { coefficient_sums(finest.mesh, finest.matrix, n, 3, finest.residual.data()); });
    parent_.assign(layout.size(), -1);
    counts_.assign(owner_.size(), -1.0);
    team.run(layout.blocks(), [&](int b) {
        const Aggregates joined = PairwiseAggregation(GraphOfBlock(finest, b, finest.residual), bound).joined();
        std::copy(joined.parent.begin(), joined.parent.end(), parent_.begin() + layout.origin(b));
        counts_[std::size_t(layout.id(b))] = joined.count;
    });
}

void AggregateLevels::number(const MultigridLevel& finest)
{
    const BlockLayout& layout = finest.mesh.layout;
    first_node_.assign(1, 0);
    for (const double count : counts_) first_node_.push_back(first_node_.back() + int(count));
    for (core::LocalBlock b = 0; b < layout.blocks(); ++b)
        for (auto c = layout.origin(b); c < layout.origin(b) + layout.cells(b).size(); ++c)
            if (int& p = parent_[std::size_t(c)]; p >= 0) p += first_node_[std::size_t(layout.id(b))];
}

void AggregateLevels::form_rows(const core::Team& team, const MultigridLevel& finest)
{
    const BlockLayout& layout = finest.mesh.layout;
    rows_.assign(owner_.size(), {});
    counts_.assign(owner_.size(), -1.0);
    team.run(layout.blocks(), [&](int b) {
        const auto id = std::size_t(layout.id(b));
        const auto origin = layout.origin(b);
        const GraphOfBlock graph(finest, b, finest.residual);
        const int first = first_node_[id];
        const NodesOfAggregates nodes({parent_.data() + origin, std::size_t(graph.nodes())}, first, first_node_[id + 1] - first);
        GraphMatrix& matrix = rows_[id];
        matrix.first.push_back(0);
        GraphRow row;
        for (int p = first; p < first_node_[id + 1]; ++p) {
            row.start(p);
            nodes.for_each(p, [&](int n) {
                row.hold(graph.shift(n));
                graph.for_each(n, [&](int other, double t) { row.tie(parent_[std::size_t(origin + other)], t); });
                if (graph.is_at_side(n))
                    for_each_link(finest, origin + n, [&](std::size_t other, double t) { row.tie(parent_[other], t); });
            });
            row.append_to(matrix);
        }
        counts_[id] = double(matrix.other.size());
    });
}

void AggregateLevels::expect_rows()
{
    for (std::size_t b = 0; b < owner_.size(); ++b) {
        const auto nodes = std::size_t(first_node_[b + 1] - first_node_[b]), ties = std::size_t(counts_[b]);
        rows_[b].first.resize(nodes + 1);
        rows_[b].shift.resize(nodes);
        rows_[b].other.resize(ties);
        rows_[b].conductance.resize(ties);
    }
}

void AggregateLevels::finish(bool singular)
{
    GraphMatrix all;
    all.first.push_back(0);
    for (GraphMatrix& rows : rows_) {
        const int before = int(all.other.size());
        for (std::size_t n = 1; n < rows.first.size(); ++n) all.first.push_back(before + rows.first[n]);
        all.other.insert(all.other.end(), rows.other.begin(), rows.other.end());
        all.conductance.insert(all.conductance.end(), rows.conductance.begin(), rows.conductance.end());
        all.shift.insert(all.shift.end(), rows.shift.begin(), rows.shift.end());
    }
    all.shrink_to_fit();
    rows_ = {};
    levels_.clear();
    levels_.emplace_back(std::move(all));
    while (levels_.back().matrix.nodes() > coarsest_nodes_) {
        GraphLevel next = coarsened(levels_.back());
        if (next.matrix.nodes() == levels_.back().matrix.nodes()) break;
        levels_.push_back(std::move(next));
    }
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l) // smaller ones have few below them, and cost little if they are solved less well
        if (levels_[l].matrix.nodes() > 3 * coarsest_nodes_) levels_[l].expect_two_visits();
    const GraphMatrix& last = levels_.back().matrix;
    entries_.clear();
    for (int n = 0; n < last.nodes(); ++n) {
        entries_.emplace_back(n, n, double(last.shift[std::size_t(n)]));
        for (int e = last.first[std::size_t(n)]; e < last.first[std::size_t(n) + 1]; ++e) {
            entries_.emplace_back(n, n, double(last.conductance[std::size_t(e)]));
            if (const int other = last.other[std::size_t(e)]; other < n)
                entries_.emplace_back(n, other, -double(last.conductance[std::size_t(e)]));
        }
    }
    factors_.analyse(last.nodes(), entries_);
    factors_.factorise(entries_, singular);
}

void AggregateLevels::gather(const core::Team& team, const MultigridLevel& finest)
{
    const BlockLayout& layout = finest.mesh.layout;
    auto& right = levels_.front().right;
    team.run(layout.blocks(), [&](int b) {
        const auto id = std::size_t(layout.id(b));
        std::fill(right.begin() + first_node_[id], right.begin() + first_node_[id + 1], 0.0F);
        for (auto c = layout.origin(b); c < layout.origin(b) + layout.cells(b).size(); ++c)
            if (const int p = parent_[std::size_t(c)]; p >= 0) right[std::size_t(p)] += finest.residual[std::size_t(c)];
    });
}

void AggregateLevels::cycle(const core::Team& team) { gain_ = GraphCycle(team, levels_, factors_).solve(0); }

void AggregateLevels::correct(const core::Team& team, MultigridLevel& finest) const
{
    const auto& coarse = levels_.front().solution;
    finest.mesh.layout.for_pieces(team, [&](int n) {
        const auto& piece = finest.mesh.layout.pieces()[std::size_t(n)];
        for (auto c = std::size_t(piece.begin); c < std::size_t(piece.end); ++c)
            if (const int p = parent_[c]; p >= 0) finest.solution[c] += gain_ * coarse[std::size_t(p)];
    });
}

std::size_t AggregateLevels::bytes() const
{
    std::size_t sum = parent_.capacity() * sizeof(int) + first_node_.capacity() * sizeof(int);
    for (const GraphLevel& l : levels_) sum += l.bytes();
    return sum;
}

} // namespace physics
