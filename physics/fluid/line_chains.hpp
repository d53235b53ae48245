// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Grid lines that go on through several blocks: which lines make a chain, in which order, and the systems of their ends.
#include "core/base/team.hpp"
#include "physics/fluid/side_patches.hpp"
#include <optional>
#include <span>
#include <vector>

namespace physics {

/// Direction of the lines that a smoother solves exactly in one block.
enum class LineAxis { i, j, k, none };

/// Which lines a block solves, and how firmly they hold to what lies beyond: the same on all ranks.
struct LineChoice {
    LineAxis axis = LineAxis::none;
    double anisotropy = 1.0;      ///< largest over smallest share of the axes in the coefficients
    std::array<double, 2> hold{}; ///< share of the links in the coefficients of the cells at the low and high ends, 0 to 1
};

/// Lines of a block one after the other: the first of the other two axes fastest.
struct BlockLines {
    BlockLines() = default;
    BlockLines(core::Extents cells, LineAxis line_axis);
    [[nodiscard]] int line(core::Index3 cell) const { return cell[u] + across * cell[v]; }
    /// Cell at the low or high end of a line.
    [[nodiscard]] core::Index3 end(int line, bool high) const;

    int axis = 0, u = 1, v = 2;
    int across = 0, count = 0, length = 0; ///< lines along u, lines, cells of a line
};

/// The chains of a level that pass through blocks of this rank, and the resistor networks between the ends of their lines.
class LineChains {
public:
    LineChains() = default;
    /// @param patches  Of all blocks.
    LineChains(std::vector<SidePatch> patches, const BlockTopology& level);

    /// Could lines go on anywhere?
    [[nodiscard]] bool possible() const { return !patches_.empty(); }
    /// Do lines go on, after the last join()?
    [[nodiscard]] bool active() const { return !chains_.empty(); }
    [[nodiscard]] bool has(core::BlockId b) const { return active() && begin_[std::size_t(b)] >= 0; }
    /// Ties the lines of blocks whose choices want it. Cheap if the choices are those of last time.
    /// @param choices  Of all blocks.
    void join(const std::vector<LineChoice>& choices);
    /// Is the cell beyond this side of a cell part of the same chain?
    [[nodiscard]] bool goes_on(core::BlockId b, core::Index3 cell, core::Side side) const { return patch_at(b, cell, side) != nullptr; }
    [[nodiscard]] const BlockLines& lines(core::BlockId b) const { return lines_[std::size_t(b)]; }
    /// Ranks and their blocks in the chains of this rank; sorted.
    struct Partner {
        int rank = 0;
        std::vector<core::BlockId> mine, theirs;
    };
    [[nodiscard]] std::span<const Partner> partners() const { return partners_; }

    /// What the chain needs of a line, one array for each: conductance to the surroundings of the cells at its ends (a line of one
    /// cell has all at its low end), from end to end, and into the links beyond.
    struct Ports {
        std::span<float> ground_low, ground_high, through, link_low, link_high;
    };
    [[nodiscard]] Ports ports(core::BlockId b);
    static constexpr int port_numbers = 5;
    /// All of the above of a block in one piece, for messages.
    [[nodiscard]] std::span<float> port_values(core::BlockId b);
    /// Currents into the ends of the lines, low ends first; solve() replaces them by the values there.
    [[nodiscard]] std::span<float> ends(core::BlockId b);

    /// Pivots of the chains. Free of subtractions.
    void factorise(const core::Team& team);
    void solve(const core::Team& team);
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Segment {
        core::BlockId block;
        int line;
        bool turned; ///< passed from its high end to the low one
    };
    struct Node {
        int end = 0;    ///< place in ends_
        int ground = 0; ///< place in ports_
        int tie = -1;   ///< place in ports_ of the conductance to the next node, of the last one to the first; -1: none
        float next = 0, first = 0, inverse = 0; ///< conductances to the next and the first node, 1 / pivot
    };
    [[nodiscard]] bool ties(const SidePatch& p, const std::vector<LineChoice>& choices) const;
    [[nodiscard]] const SidePatch* patch_at(core::BlockId b, core::Index3 cell, core::Side side) const;
    [[nodiscard]] std::optional<Segment> next(const Segment& s) const;
    [[nodiscard]] std::vector<Segment> chain_through(Segment s, bool& ring) const;
    /// For each block the least block that it has chains with.
    [[nodiscard]] std::vector<core::BlockId> groups() const;
    void lay_out();
    void find_partners(const std::vector<core::BlockId>& group);
    void add_chain(const std::vector<Segment>& chain, bool ring);
    void factorise_chain(std::span<Node> nodes) const;
    void solve_chain(std::span<const Node> nodes);
    template <class Body>
    void for_chains(const core::Team& team, Body body) const;

    std::vector<SidePatch> patches_;
    std::vector<core::Extents> cells_;
    std::vector<int> owner_;
    int rank_ = 0;
    std::vector<char> tied_;        ///< of each patch
    std::vector<BlockLines> lines_; ///< of each block
    std::vector<int> begin_;        ///< first line of each block in the arrays, -1 without
    std::vector<float> ports_, ends_;
    std::vector<Node> nodes_;
    std::vector<int> chains_; ///< first node of each chain, and the end; empty: none
    std::vector<Partner> partners_;
};

} // namespace physics
