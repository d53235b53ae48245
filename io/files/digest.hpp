// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Hashes of a state that do not depend on how it is spread over ranks: one for each block of a field, one for each
// 4096 rows of a column, and one line that stands for all of them. XXH3, 64 bits.
#include "core/comm/communicator.hpp"
#include "io/files/field_views.hpp"
#include <cstdint>
#include <map>

namespace io {

using Hashes = std::vector<std::uint64_t>;

/// Rows that share a hash.
inline constexpr std::int64_t rows_per_hash = 4096;

/// Of the interior values of one block.
[[nodiscard]] std::uint64_t block_hash(std::span<const double> values, core::BlockId block);

/// What rows [first, first + n) add to the hash of each chunk of a column of `total` rows: each row is hashed with its number
/// as the seed, and the hashes are summed, so that parts of a chunk may come from different ranks.
/// @param bytes  The n rows, one after the other; n follows from row_bytes.
[[nodiscard]] Hashes row_hashes(std::span<const std::byte> bytes, std::size_t row_bytes, std::int64_t first, std::int64_t total);

/// Element-wise sum over the ranks, modulo 2^64.
void sum_over_ranks(const core::Communicator& ranks, Hashes& hashes);

/// Hashes of everything that a state consists of, by name.
class Contents {
public:
    void set(const std::string& name, Hashes hashes) { data_[name] = std::move(hashes); }
    void set_scalar(const std::string& name, double value) { scalars_[name] = value; }
    void set_note(const std::string& name, const std::string& text) { notes_[name] = text; }
    /// Of fields, columns and scalars: 16 hexadecimal digits.
    [[nodiscard]] std::string digest() const;
    /// Of the notes too: what a checkpoint carries as its seal.
    [[nodiscard]] std::string seal() const;

private:
    std::map<std::string, Hashes> data_;
    std::map<std::string, double> scalars_;
    std::map<std::string, std::string> notes_;
};

/// The digest of a state in memory: the same line as that of a checkpoint of this state. Calls are collective.
class StateDigest {
public:
    explicit StateDigest(const core::Communicator& ranks) : ranks_(ranks) {}
    void field(const FieldViews<const double>& field, const BlockList& blocks);
    /// Rows of this rank in their global order, as RowOrder gives them. T is double or std::int64_t.
    template <class T>
    void rows(const std::string& name, std::span<const T> values, int components, std::int64_t first, std::int64_t total)
    {
        Hashes hashes = row_hashes(std::as_bytes(values), sizeof(T) * std::size_t(components), first, total);
        sum_over_ranks(ranks_, hashes);
        contents_.set("rows/" + name, std::move(hashes));
    }
    void scalar(const std::string& name, double value) { contents_.set_scalar(name, value); }
    [[nodiscard]] std::string line() const { return contents_.digest(); }

private:
    core::Communicator ranks_;
    Contents contents_;
};

} // namespace io
