// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/digest.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <bit>

namespace io {
namespace {

void append(std::string& bytes, std::uint64_t value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }

void append(std::string& bytes, const std::string& text)
{
    append(bytes, text.size());
    bytes += text;
}

std::string hexadecimal(const std::string& bytes) { return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size())); }

std::string state_bytes(const std::map<std::string, Hashes>& data, const std::map<std::string, double>& scalars)
{
    std::string bytes;
    for (const auto& [name, hashes] : data) {
        append(bytes, name);
        append(bytes, hashes.size());
        for (const std::uint64_t hash : hashes) append(bytes, hash);
    }
    for (const auto& [name, value] : scalars) {
        append(bytes, name);
        append(bytes, std::bit_cast<std::uint64_t>(value));
    }
    return bytes;
}

} // namespace

std::uint64_t block_hash(std::span<const double> values, core::BlockId block)
{
    return XXH3_64bits_withSeed(values.data(), values.size_bytes(), XXH64_hash_t(block));
}

Hashes row_hashes(std::span<const std::byte> bytes, std::size_t row_bytes, std::int64_t first, std::int64_t total)
{
    Hashes hashes(std::size_t((total + rows_per_hash - 1) / rows_per_hash), 0);
    const auto count = std::int64_t(bytes.size() / row_bytes);
    for (std::int64_t row = 0; row < count; ++row) {
        const std::byte* values = bytes.data() + std::size_t(row) * row_bytes;
        hashes[std::size_t((first + row) / rows_per_hash)] += XXH3_64bits_withSeed(values, row_bytes, XXH64_hash_t(first + row));
    }
    return hashes;
}

void sum_over_ranks(const core::Communicator& ranks, Hashes& hashes)
{
    if (ranks.size() == 1) return;
    std::vector<std::int64_t> sums(hashes.begin(), hashes.end());
    ranks.sum(sums);
    hashes.assign(sums.begin(), sums.end());
}

std::string Contents::digest() const { return hexadecimal(state_bytes(data_, scalars_)); }

std::string Contents::seal() const
{
    std::string bytes = state_bytes(data_, scalars_);
    for (const auto& [name, text] : notes_) {
        append(bytes, name);
        append(bytes, text);
    }
    return hexadecimal(bytes);
}

void StateDigest::field(const FieldViews<const double>& field, const BlockList& blocks)
{
    Hashes hashes(std::size_t(blocks.total), 0);
    for (std::size_t b = 0; b < blocks.own.size(); ++b)
        hashes[std::size_t(blocks.own[b])] = block_hash(interior(field.blocks[b]), blocks.own[b]);
    sum_over_ranks(ranks_, hashes);
    contents_.set("fields/" + field.name, std::move(hashes));
}

} // namespace io
