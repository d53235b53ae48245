// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Rows that are scattered over the ranks, brought into the order of their keys: what is written then does not depend on
// the number of ranks.
#include "core/comm/communicator.hpp"
#include <array>
#include <cstdint>

namespace io {

/// Particles: {id, 0, 0}. Contacts: {low id, high id, periodic image}.
using RowKey = std::array<std::int64_t, 3>;

/// Share of rank `rank` when `total` rows are spread evenly: {first, count}.
struct RowShare {
    std::int64_t first = 0, count = 0;
};
[[nodiscard]] RowShare even_share(std::int64_t total, const core::Communicator& ranks);

/// The order of the keys of all ranks; made once, then applied to every column.
class RowOrder {
public:
    /// Collective. Keys must be different from each other; first numbers are not negative.
    RowOrder(const core::Communicator& ranks, std::span<const RowKey> keys);

    /// This rank's part of the sorted column. Collective. T is double or std::int64_t.
    /// @param column  One row of `components` numbers for each key of this rank.
    template <class T>
    [[nodiscard]] std::vector<T> apply(std::span<const T> column, int components) const;

    [[nodiscard]] std::int64_t first_row() const { return first_; }
    [[nodiscard]] std::int64_t total_rows() const { return total_; }

private:
    core::Communicator ranks_;
    std::vector<std::vector<std::size_t>> send_; ///< [rank] rows of mine that go there
    std::vector<std::size_t> place_;             ///< of each arriving row in the sorted part
    std::int64_t first_ = 0, total_ = 0;
};

} // namespace io
