// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A conservative operator on a graph: nodes joined by conductances, some held by a shift. The coarse levels of AggregateLevels.
#include <cstddef>
#include <vector>

namespace physics {

/// Net flow out of a node: sum of conductance (x_node - x_other) + shift x_node.
struct GraphMatrix {
    std::vector<int> first;         ///< entry of each node, and the end
    std::vector<int> other;         ///< of each entry: the node at its far end
    std::vector<float> conductance; ///< of each entry
    std::vector<float> shift;       ///< of each node

    [[nodiscard]] int nodes() const { return int(shift.size()); }
    void shrink_to_fit()
    {
        first.shrink_to_fit();
        other.shrink_to_fit();
        conductance.shrink_to_fit();
        shift.shrink_to_fit();
    }
    [[nodiscard]] std::size_t bytes() const
    {
        return (first.capacity() + other.capacity()) * sizeof(int) + (conductance.capacity() + shift.capacity()) * sizeof(float);
    }
};

/// Sums up what a node of a coarse graph is tied to, whatever the order in which its parts say it.
class GraphRow {
public:
    void start(int node)
    {
        node_ = node;
        shift_ = 0.0;
        ties_.clear();
    }
    void hold(double shift) { shift_ += shift; }
    /// @param other  Node at the far end; -1: one that has no part in the coarse level.
    void tie(int other, double conductance)
    {
        if (other == node_) return;
        if (other < 0) return hold(conductance);
        for (Tie& t : ties_)
            if (t.other == other) {
                t.conductance += conductance;
                return;
            }
        ties_.push_back({other, conductance});
    }
    void append_to(GraphMatrix& matrix) const
    {
        for (const Tie& t : ties_) {
            matrix.other.push_back(t.other);
            matrix.conductance.push_back(float(t.conductance));
        }
        matrix.shift.push_back(float(shift_));
        matrix.first.push_back(int(matrix.other.size()));
    }

private:
    struct Tie {
        int other;
        double conductance; ///< in 64 bits: both ends find the same 32 bits in the order of their own
    };
    int node_ = 0;
    double shift_ = 0.0;
    std::vector<Tie> ties_;
};

} // namespace physics
