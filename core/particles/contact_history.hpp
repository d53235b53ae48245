// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the touching contacts of each owned particle remember, while no list of pairs holds it: during a rebuild, on the way
// to another rank, in a checkpoint.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// The springs of one contact: its tangential displacement [m], then, where the scene has springs against rolling, the turn
/// that they hold [rad]: rolling across the normal, twist along it.
using Spring = std::array<double, 6>;
inline constexpr int tangential_memory = 3; ///< Numbers that a contact remembers without springs against rolling.
inline constexpr int rolling_memory = 6;    ///< The same with them.

/// Rows, one for each owned particle. `other` is the id of the other particle, or a wall as wall_key() writes it. Springs
/// of pairs are oriented from the lower id to the higher one, so both rows of a pair hold the same numbers.
struct ContactHistory {
    int width = tangential_memory; ///< Numbers of each contact that are kept, 3 or 6.
    std::vector<int> start{0};
    std::vector<std::int64_t> other;
    std::vector<double> spring; ///< `width` numbers for each contact.

    [[nodiscard]] int rows() const { return int(start.size()) - 1; }
    [[nodiscard]] int row_size(int row) const { return start[std::size_t(row) + 1] - start[std::size_t(row)]; }

    void add(std::int64_t with, const Spring& value)
    {
        other.push_back(with);
        spring.insert(spring.end(), value.begin(), value.begin() + width);
    }
    void end_row() { start.push_back(int(other.size())); }

    [[nodiscard]] Spring spring_of(int contact) const
    {
        Spring value{};
        for (int a = 0; a < width; ++a) value[std::size_t(a)] = spring[std::size_t(width * contact + a)];
        return value;
    }

    /// The spring of `row` with `with`; zero if they did not touch.
    [[nodiscard]] Spring find(int row, std::int64_t with) const
    {
        for (int k = start[std::size_t(row)]; k < start[std::size_t(row) + 1]; ++k)
            if (other[std::size_t(k)] == with) return spring_of(k);
        return {};
    }

    /// Drops all rows and gives their memory back.
    void release() { *this = ContactHistory{width, {0}, {}, {}}; }
    /// Drops all rows.
    void clear()
    {
        start.assign(1, 0);
        other.clear();
        spring.clear();
    }

    /// Row k becomes what row order[k] was; rows not named are dropped.
    void reorder(std::span<const int> order)
    {
        ContactHistory next;
        next.width = width;
        for (const int old : order) {
            for (int k = start[std::size_t(old)]; k < start[std::size_t(old) + 1]; ++k) next.add(other[std::size_t(k)], spring_of(k));
            next.end_row();
        }
        *this = std::move(next);
    }
};

/// Key of a wall's feature: negative, so that it never meets the id of a particle.
[[nodiscard]] constexpr std::int64_t wall_key(std::int64_t feature) { return -1 - feature; }

} // namespace core
