// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tangential springs of the touching contacts of each owned particle, while no list of pairs holds them: during a
// rebuild, on the way to another rank, in a checkpoint.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

using Spring = std::array<double, 3>;

/// Rows, one for each owned particle. `other` is the id of the other particle, or a wall as wall_key() writes it. Springs
/// of pairs are oriented from the lower id to the higher one, so both rows of a pair hold the same numbers.
struct ContactHistory {
    std::vector<int> start{0};
    std::vector<std::int64_t> other;
    std::vector<Spring> spring;

    [[nodiscard]] int rows() const { return int(start.size()) - 1; }

    void add(std::int64_t with, const Spring& value)
    {
        other.push_back(with);
        spring.push_back(value);
    }
    void end_row() { start.push_back(int(other.size())); }

    /// The spring of `row` with `with`; zero if they did not touch.
    [[nodiscard]] Spring find(int row, std::int64_t with) const
    {
        for (int k = start[std::size_t(row)]; k < start[std::size_t(row) + 1]; ++k)
            if (other[std::size_t(k)] == with) return spring[std::size_t(k)];
        return {0.0, 0.0, 0.0};
    }

    /// Row k becomes what row order[k] was; rows not named are dropped.
    void reorder(std::span<const int> order)
    {
        ContactHistory next;
        for (const int old : order) {
            for (int k = start[std::size_t(old)]; k < start[std::size_t(old) + 1]; ++k)
                next.add(other[std::size_t(k)], spring[std::size_t(k)]);
            next.end_row();
        }
        *this = std::move(next);
    }
};

/// Key of a wall's feature: negative, so that it never meets the id of a particle.
[[nodiscard]] constexpr std::int64_t wall_key(std::int64_t feature) { return -1 - feature; }

} // namespace core
