// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Nodes of a graph joined in aggregates of at most eight that hold together well enough for one value to serve all of them.
#include <algorithm>
#include <array>
#include <cstdint>
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

inline constexpr std::size_t most_joined = 8;
/// Conductances from node to node of an aggregate, symmetric.
using AggregateTies = std::array<std::array<double, most_joined>, most_joined>;

/// Do these nodes hold together: is, whatever their values v, sum of d (v - mean)^2 at most bound / 2 of the sum of t (v_m - v_n)^2?
/// d are all conductances of a node, t those between the nodes, the mean is weighted with d: then aggregates with a damped
/// Jacobi method leave a two-level method whose condition number is about `bound`, whatever the jumps.
/// @param sums  d of each node.
/// @param ties  t.
/// @source  Napov & Notay, SIAM J. Sci. Comput. 34 (2012) A1079, theorem 3.2.
[[nodiscard]] bool holds_together(std::span<const double> sums, const AggregateTies& ties, double bound);

/// Joins nodes, then aggregates, in pairs.
/// @tparam Graph  nodes(); sum(n), of all conductances and the shift of a node; shift(n), of what has no part in the coarse level;
///                for_each(n, body(other, t)) for the neighbours that n may be joined with.
template <class Graph>
class PairwiseAggregation {
public:
    PairwiseAggregation(const Graph& graph, double bound)
        : graph_(graph), bound_(bound), parent_(std::size_t(graph.nodes()), -1), place_(std::size_t(graph.nodes()), 0)
    {
        constexpr double enough = 0.25; // of the conductances: a Jacobi step leaves little of what is held so firmly
        groups_.reserve(parent_.size());
        for (int n = 0; n < graph.nodes(); ++n) {
            const double shift = graph.shift(n), sum = graph.sum(n);
            if (!(sum > shift) || shift > enough * (sum - shift)) continue;
            parent_[std::size_t(n)] = int(groups_.size());
            groups_.push_back({{n}, 1, sum});
        }
    }

    [[nodiscard]] Aggregates joined() &&
    {
        constexpr int passes = 4; // the fourth picks up what was left alone
        for (int pass = 0; pass < passes; ++pass) join_pairs();
        return {std::move(parent_), int(groups_.size())};
    }

private:
    struct Group {
        std::array<int, most_joined> nodes;
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
        candidate_.assign(groups_.size(), -1);
        std::vector<Group> next;
        next.reserve(groups_.size());
        for (int g = 0; g < int(groups_.size()); ++g) {
            if (taken_[std::size_t(g)] >= 0) continue;
            taken_[std::size_t(g)] = int(next.size());
            next.push_back(groups_[std::size_t(g)]);
            const Candidate partner = best_partner(g);
            if (partner.group < 0) continue;
            taken_[std::size_t(partner.group)] = taken_[std::size_t(g)];
            add(groups_[std::size_t(partner.group)], partner.tie, next.back());
        }
        for (int& p : parent_)
            if (p >= 0) p = taken_[std::size_t(p)];
        groups_ = std::move(next);
    }

    void add(const Group& group, double tie, Group& to)
    {
        for (int m = 0; m < group.size; ++m) {
            const int node = group.nodes[std::size_t(m)];
            place_[std::size_t(node)] = std::uint8_t(to.size);
            to.nodes[std::size_t(to.size++)] = node;
        }
        to.open = std::max(to.open + group.open - 2 * tie, 0.0);
    }

    /// The free neighbour that makes the best pair with a group, of those that hold together with it; group -1 if there is none.
    [[nodiscard]] Candidate best_partner(int g)
    {
        find_candidates(g);
        while (!candidates_.empty()) {
            const auto best = std::min_element(candidates_.begin(), candidates_.end(),
                                               [](const Candidate& l, const Candidate& r) { return l.condition < r.condition; });
            if (best->condition > bound_) break;
            if (hold_together(g, best->group)) return *best;
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
                if (h < 0 || h == g || !(t > 0.0) || taken_[std::size_t(h)] >= 0) return;
                int& known = candidate_[std::size_t(h)];
                if (known >= 0) candidates_[std::size_t(known)].tie += t;
                else if (std::size_t(group.size + groups_[std::size_t(h)].size) <= most_joined) {
                    known = int(candidates_.size());
                    candidates_.push_back({h, t, 0.0});
                }
            });
        for (Candidate& c : candidates_) {
            candidate_[std::size_t(c.group)] = -1;
            c.condition = condition(group.open, groups_[std::size_t(c.group)].open, c.tie);
        }
    }

    /// Of a pair of rigid groups.
    /// @source  Notay, SIAM J. Sci. Comput. 34 (2012) A2288, section 2.
    [[nodiscard]] static double condition(double open_a, double open_b, double tie)
    {
        const double a = std::max(open_a - tie, 0.0), b = std::max(open_b - tie, 0.0);
        return a + b > 0.0 ? 1.0 + 2.0 * a * b / ((a + b) * tie) : 1.0;
    }

    [[nodiscard]] bool hold_together(int a, int b)
    {
        const std::array pair{a, b};
        const std::array first{std::size_t(0), std::size_t(groups_[std::size_t(a)].size)}; // place of its first node
        const auto size = first[1] + std::size_t(groups_[std::size_t(b)].size);
        for (std::size_t m = 0; m < size; ++m) ties_[m].fill(0.0);
        for (std::size_t part = 0; part < 2; ++part) {
            const Group& group = groups_[std::size_t(pair[part])];
            for (std::size_t m = 0; m < std::size_t(group.size); ++m) {
                auto& row = ties_[first[part] + m];
                sums_[first[part] + m] = graph_.sum(group.nodes[m]);
                graph_.for_each(group.nodes[m], [&](int other, double t) {
                    const int h = parent_[std::size_t(other)];
                    if (h == a || h == b) row[first[h == b] + place_[std::size_t(other)]] += t;
                });
            }
        }
        return holds_together(std::span(sums_).first(size), ties_, bound_);
    }

    const Graph& graph_;
    double bound_;
    std::vector<int> parent_;
    std::vector<std::uint8_t> place_; ///< of each node in its group
    std::vector<Group> groups_;
    std::vector<int> taken_;     ///< of each group its number after this pass, -1: not known yet
    std::vector<int> candidate_; ///< of each group its number among the candidates, -1: none
    std::vector<Candidate> candidates_;
    std::array<double, most_joined> sums_{}; ///< of the pair that is judged, as are the ties
    AggregateTies ties_{};
};

} // namespace physics
