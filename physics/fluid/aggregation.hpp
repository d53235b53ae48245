// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Nodes of a graph joined in aggregates of at most four that hold together well enough for one value to serve all of them.
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace physics {

struct Aggregates {
    std::vector<int> parent; ///< of each node its aggregate; -1: left out, for smoothing alone serves it
    int count = 0;
};

/// The nodes of each aggregate, as lists.
class NodesOfAggregates {
public:
    /// @param first  The least number of an aggregate.
    NodesOfAggregates(std::span<const int> parent, int first, int count)
        : first_(first), last_(std::size_t(count), -1), before_(parent.size(), -1)
    {
        for (std::size_t n = 0; n < parent.size(); ++n) {
            if (parent[n] < 0) continue;
            int& last = last_[std::size_t(parent[n] - first)];
            before_[n] = std::exchange(last, int(n));
        }
    }
    /// body(node), the last one first.
    template <class Body>
    void for_each(int aggregate, Body body) const
    {
        for (int n = last_[std::size_t(aggregate - first_)]; n >= 0; n = before_[std::size_t(n)]) body(n);
    }

private:
    int first_;
    std::vector<int> last_, before_;
};

/// Do these nodes hold together: is, whatever their values v, sum of d (v - mean)^2 at most bound / 2 of the sum of t (v_m - v_n)^2?
/// d are all conductances of a node, t those between the nodes, the mean is weighted with d: then aggregates with a damped
/// Jacobi method leave a two-level method whose condition number is about `bound`, whatever the jumps.
/// @param sums  d of each node.
/// @param ties  t from node to node, symmetric.
/// @source  Napov & Notay, SIAM J. Sci. Comput. 34 (2012) A1079, theorem 3.2.
[[nodiscard]] bool holds_together(std::span<const double> sums, const std::array<std::array<double, 4>, 4>& ties, double bound);

/// Joins nodes, then aggregates, in pairs.
/// @tparam Graph  nodes(); sum(n), of all conductances and the shift of a node; shift(n), of what has no part in the coarse level;
///                for_each(n, body(other, t)) for the neighbours that n may be joined with.
template <class Graph>
class PairwiseAggregation {
public:
    PairwiseAggregation(const Graph& graph, double bound) : graph_(graph), bound_(bound), parent_(std::size_t(graph.nodes()), -1)
    {
        constexpr double enough = 0.25; // of the conductances: a Jacobi step leaves little of what is held so firmly
        for (int n = 0; n < graph.nodes(); ++n) {
            const double shift = graph.shift(n), sum = graph.sum(n);
            if (!(sum > shift) || shift > enough * (sum - shift)) continue;
            parent_[std::size_t(n)] = int(groups_.size());
            groups_.push_back({{n, -1, -1, -1}, 1, sum});
        }
    }

    [[nodiscard]] Aggregates joined() &&
    {
        constexpr int passes = 3; // the third picks up what was left alone
        for (int pass = 0; pass < passes; ++pass) join_pairs();
        return {std::move(parent_), int(groups_.size())};
    }

private:
    struct Group {
        std::array<int, 4> nodes;
        int size;
        double open; ///< conductances to what is not part of it
    };
    struct Candidate {
        int group;
        double tie, condition;
    };

    void join_pairs()
    {
        taken_.assign(groups_.size(), -1);
        std::vector<Group> next;
        next.reserve(groups_.size());
        for (int g = 0; g < int(groups_.size()); ++g) {
            if (taken_[std::size_t(g)] >= 0) continue;
            taken_[std::size_t(g)] = int(next.size());
            next.push_back(groups_[std::size_t(g)]);
            const Candidate partner = best_partner(g);
            if (partner.group < 0) continue;
            taken_[std::size_t(partner.group)] = taken_[std::size_t(g)];
            next.back() = merged(groups_[std::size_t(g)], groups_[std::size_t(partner.group)], partner.tie);
        }
        for (int& p : parent_)
            if (p >= 0) p = taken_[std::size_t(p)];
        groups_ = std::move(next);
    }

    [[nodiscard]] static Group merged(Group a, const Group& b, double tie)
    {
        std::copy_n(b.nodes.begin(), b.size, a.nodes.begin() + a.size);
        a.size += b.size;
        a.open = std::max(a.open + b.open - 2 * tie, 0.0);
        return a;
    }

    /// The free neighbour that makes the best pair with a group, of those that hold together with it; group -1 if there is none.
    [[nodiscard]] Candidate best_partner(int g)
    {
        find_candidates(g);
        while (!candidates_.empty()) {
            const auto best = std::min_element(candidates_.begin(), candidates_.end(),
                                               [](const Candidate& l, const Candidate& r) { return l.condition < r.condition; });
            if (best->condition > bound_) break;
            if (hold_together(groups_[std::size_t(g)], groups_[std::size_t(best->group)])) return *best;
            candidates_.erase(best);
        }
        return {-1, 0.0, 0.0};
    }

    void find_candidates(int g)
    {
        const Group& group = groups_[std::size_t(g)];
        candidates_.clear();
        for (int m = 0; m < group.size; ++m)
            graph_.for_each(group.nodes[std::size_t(m)], [&](int other, double t) {
                const int h = parent_[std::size_t(other)];
                if (h < 0 || h == g || !(t > 0.0) || taken_[std::size_t(h)] >= 0 || group.size + groups_[std::size_t(h)].size > 4) return;
                const auto known = std::find_if(candidates_.begin(), candidates_.end(), [h](const Candidate& c) { return c.group == h; });
                if (known == candidates_.end()) candidates_.push_back({h, t, 0.0});
                else known->tie += t;
            });
        for (Candidate& c : candidates_) c.condition = condition(group.open, groups_[std::size_t(c.group)].open, c.tie);
    }

    /// Of a pair of rigid groups.
    /// @source  Notay, SIAM J. Sci. Comput. 34 (2012) A2288, section 2.
    [[nodiscard]] static double condition(double open_a, double open_b, double tie)
    {
        const double a = std::max(open_a - tie, 0.0), b = std::max(open_b - tie, 0.0);
        return a + b > 0.0 ? 1.0 + 2.0 * a * b / ((a + b) * tie) : 1.0;
    }

    [[nodiscard]] bool hold_together(const Group& a, const Group& b) const
    {
        const Group both = merged(a, b, 0.0);
        std::array<double, 4> sums{};
        std::array<std::array<double, 4>, 4> ties{};
        for (std::size_t m = 0; m < std::size_t(both.size); ++m) {
            sums[m] = graph_.sum(both.nodes[m]);
            graph_.for_each(both.nodes[m], [&](int other, double t) {
                for (std::size_t n = 0; n < m; ++n)
                    if (both.nodes[n] == other) ties[m][n] = ties[n][m] += t;
            });
        }
        return holds_together(std::span(sums).first(std::size_t(both.size)), ties, bound_);
    }

    const Graph& graph_;
    double bound_;
    std::vector<int> parent_;
    std::vector<Group> groups_;
    std::vector<int> taken_; ///< of each group its number after this pass, -1: not known yet
    std::vector<Candidate> candidates_;
};

} // namespace physics
