// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/row_order.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace io {
namespace {

template <class T>
void append(std::vector<std::byte>& bytes, const T* values, std::size_t count)
{
    const auto* first = reinterpret_cast<const std::byte*>(values);
    bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

template <class T>
std::vector<T> joined(const std::vector<std::vector<std::byte>>& parts)
{
    std::vector<T> all;
    for (const auto& part : parts) {
        const std::size_t old = all.size();
        all.resize(old + part.size() / sizeof(T));
        if (!part.empty()) std::memcpy(all.data() + old, part.data(), part.size());
    }
    return all;
}

} // namespace

RowShare even_share(std::int64_t total, const core::Communicator& ranks)
{
    const std::int64_t first = total * ranks.rank() / ranks.size(), next = total * (ranks.rank() + 1) / ranks.size();
    return {first, next - first};
}

RowOrder::RowOrder(const core::Communicator& ranks, std::span<const RowKey> keys) : ranks_(ranks), send_(std::size_t(ranks.size()))
{
    std::int64_t end = 1;
    for (const RowKey& key : keys) end = std::max(end, key[0] + 1);
    ranks.max({&end, 1});
    std::vector<std::vector<std::byte>> out(send_.size());
    for (std::size_t row = 0; row < keys.size(); ++row) {
        const auto rank = std::size_t(double(keys[row][0]) / double(end) * ranks.size());
        send_[rank].push_back(row);
        append(out[rank], keys[row].data(), 3);
    }
    const auto arrived = joined<RowKey>(ranks.exchange_all(out));
    std::vector<std::size_t> order(arrived.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return arrived[a] < arrived[b]; });
    place_.resize(order.size());
    for (std::size_t place = 0; place < order.size(); ++place) place_[order[place]] = place;

    std::vector<std::int64_t> counts(send_.size(), 0);
    counts[std::size_t(ranks.rank())] = std::int64_t(arrived.size());
    ranks.sum(counts);
    first_ = std::accumulate(counts.begin(), counts.begin() + ranks.rank(), std::int64_t(0));
    total_ = std::accumulate(counts.begin(), counts.end(), std::int64_t(0));
}

template <class T>
std::vector<T> RowOrder::apply(std::span<const T> column, int components) const
{
    const auto width = std::size_t(components);
    std::vector<std::vector<std::byte>> out(send_.size());
    for (std::size_t rank = 0; rank < send_.size(); ++rank)
        for (const std::size_t row : send_[rank]) append(out[rank], column.data() + row * width, width);
    const auto arrived = joined<T>(ranks_.exchange_all(out));
    std::vector<T> sorted(arrived.size());
    for (std::size_t row = 0; row < place_.size(); ++row)
        std::copy_n(arrived.begin() + std::ptrdiff_t(row * width), width, sorted.begin() + std::ptrdiff_t(place_[row] * width));
    return sorted;
}

template std::vector<double> RowOrder::apply<double>(std::span<const double>, int) const;
template std::vector<std::int64_t> RowOrder::apply<std::int64_t>(std::span<const std::int64_t>, int) const;

} // namespace io
